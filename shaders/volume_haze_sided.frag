#version 410 core
// Ω with its haze, where φ is nowhere 0 between the sides.
#define HAZE
#define TWO_SIDED
#include "volume.glsl"
