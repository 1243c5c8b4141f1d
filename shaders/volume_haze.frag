#version 410 core
// Ω with its haze, where φ is 0 between the sides.
#define HAZE
#include "volume.glsl"
