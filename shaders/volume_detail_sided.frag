#version 410 core
// Both boundaries of Ω with a part in finer voxels, where φ is nowhere 0 between the sides.
#define DETAIL
#define TWO_SIDED
#include "volume.glsl"
