#version 410 core
// Both boundaries of Ω, where φ is nowhere 0 between the sides, which have a texture of their own.
#define TWO_SIDED
#include "volume.glsl"
