#version 410 core
// Triangles in their own colour, without light.
#include "mesh_shade.glsl"
layout(location = 0) out vec4 colour;
void main() {
  if (clipped(world)) discard;
  float alpha = facet_tint.a * opacity;
  colour = vec4(facet_tint.rgb * alpha, alpha);
}
