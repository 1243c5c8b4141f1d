#version 410 core
// Translucent triangles, in any order.
#include "mesh_shade.glsl"
#include "blend.glsl"
layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 cover;
void main() {
  if (clipped(world)) discard;
  vec4 c = mesh_colour();
  float weight = blend_weight(view_depth(world), c.a);
  sum = vec4(c.rgb * c.a, c.a) * weight;
  cover = vec4(c.a);
}
