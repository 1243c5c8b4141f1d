#version 410 core
// The ground of the 2D section, with a part of Ω in finer voxels.
#define DETAIL
#define TWO_SIDED
#include "section.glsl"
