#version 410 core
// Points of the input as camera-facing sprites, as samples are, but smaller and in the colour of their weight.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint; // a: 0 where the point was dropped
uniform float size;      // pixels at the target's distance
uniform float spacing;   // scene units between neighbours
flat out vec3 colour_of;
flat out uint dropped;
flat out float radius;
flat out float fog;
void main() {
  colour_of = tint.rgb;
  dropped = tint.a < 0.5 ? 1u : 0u;
  float depth = eye.w > 0.5 ? view_depth(position) : forward.w;
  float near = clamp(forward.w / max(depth, 1e-20), 0.35, 2.5);
  float wanted = size * viewport.z * near * (dropped == 1u ? 1.6 : 1.0);
  if (dropped == 0u) wanted = min(wanted, 0.8 * spacing * pixels_per_unit(position));
  float diameter = max(wanted, (dropped == 1u ? 4.5 : 1.8) * viewport.z);
  radius = 0.5 * diameter;
  fog = clamp(1.0 - near, 0.0, 0.5);
  gl_Position = view_projection * vec4(position, 1.0);
  gl_PointSize = diameter + 1.5;
  if (clipped(position)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
