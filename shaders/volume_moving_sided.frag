#version 410 core
// Ω in a moving frame, where φ is nowhere 0 between the sides.
#define MOVING
#define TWO_SIDED
#include "volume.glsl"
