#version 410 core
// Opaque triangles.
#include "mesh_shade.glsl"
layout(location = 0) out vec4 colour;
void main() {
  if (clipped(world)) discard;
  colour = vec4(mesh_colour().rgb, 1.0);
}
