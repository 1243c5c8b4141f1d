#version 410 core
// Ω in a moving frame, where φ is 0 between the sides.
#define MOVING
#include "volume.glsl"
