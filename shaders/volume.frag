#version 410 core
// Ω where φ is 0 between the sides.
#include "volume.glsl"
