#version 410 core
// Triangles in their own colour, without light.
#include "mesh_shade.glsl"
layout(location = 0) out vec4 colour;
void main() {
  if (clipped(world)) discard;
  float ink = walls == 0 ? 0.0 : hatch_cover(front_hatch, world);
  float alpha = facet_tint.a * min(opacity * (1.0 + 1.4 * ink), 1.0);
  colour = vec4(mix(walls == 0 ? facet_tint.rgb : front_tint, front_ink, ink) * alpha, alpha);
}
