#version 410 core
// The ground of the 2D section.
#define TWO_SIDED
#include "section.glsl"
