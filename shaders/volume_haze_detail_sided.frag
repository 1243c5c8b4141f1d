#version 410 core
// Ω with its haze and a part in finer voxels, where φ is nowhere 0 between the sides.
#define DETAIL
#define HAZE
#define TWO_SIDED
#include "volume.glsl"
