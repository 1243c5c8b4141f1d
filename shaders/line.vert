#version 410 core
// A segment widened to a rectangle on the screen; each segment comes as four vertices.
#include "frame.glsl"
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in uvec4 shape; // x: bit 0 end, bit 1 side; y: width in eighths of a pixel; z: 1 dashed
layout(location = 3) in vec4 tint;
uniform float toward; // how far towards the viewer, as a part of the distance
noperspective out float across;
noperspective out float along;
out vec3 world;
flat out float half_width;
flat out uint dashed;
flat out vec4 line_tint;

vec4 project(vec3 p) {
  vec3 shifted = eye.w > 0.5 ? mix(p, eye.xyz, toward) : p - forward.xyz * forward.w * toward;
  return view_projection * vec4(shifted, 1.0);
}

void main() {
  vec4 a = project(from), b = project(to);
  float near_a = a.z + a.w, near_b = b.z + b.w;
  vec4 start = a, end = b;
  if (near_a < 0.0 && near_b > 0.0) start = mix(a, b, near_a / (near_a - near_b));
  if (near_b < 0.0 && near_a > 0.0) end = mix(b, a, near_b / (near_b - near_a));
  bool last = (shape.x & 1u) != 0u;
  float side = (shape.x & 2u) != 0u ? 1.0 : -1.0;
  half_width = 0.5 * float(shape.y) / 8.0 * viewport.z;
  dashed = shape.z;
  line_tint = tint;
  world = last ? to : from;
  vec2 s = 0.5 * viewport.xy * start.xy / start.w, e = 0.5 * viewport.xy * end.xy / end.w;
  float pixels = length(e - s);
  vec2 direction = pixels > 1e-6 ? (e - s) / pixels : vec2(1.0, 0.0);
  float reach = half_width + 1.0;
  across = side * reach;
  along = last ? pixels + half_width : -half_width;
  vec4 here = last ? end : start;
  vec2 offset = vec2(-direction.y, direction.x) * side * reach + direction * (last ? half_width : -half_width);
  here.xy += offset / (0.5 * viewport.xy) * here.w;
  gl_Position = near_a < 0.0 && near_b < 0.0 ? vec4(2.0, 2.0, 2.0, 1.0) : here;
}
