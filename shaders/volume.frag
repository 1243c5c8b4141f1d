#version 410 core
// Both boundaries of Ω, where φ is 0 between the sides.
#include "volume.glsl"
