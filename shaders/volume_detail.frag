#version 410 core
// Both boundaries of Ω with a part in finer voxels, where φ is 0 between the sides.
#define DETAIL
#include "volume.glsl"
