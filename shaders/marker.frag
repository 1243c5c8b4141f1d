#version 410 core
// Rings, discs, crosses, squares, diamonds, triangles, with smooth edges; from 8 on the outline alone.
#include "frame.glsl"
in vec3 world;
flat in vec4 mark_tint;
flat in uint shape;
flat in float radius;
uniform float opacity;
layout(location = 0) out vec4 colour;
float capsule(vec2 p, vec2 tip) { return length(p - tip * clamp(dot(p, tip) / dot(tip, tip), -1.0, 1.0)); }
void main() {
  if (clipped(world)) discard;
  vec2 p = (gl_PointCoord - 0.5) * (2.0 * radius + 2.0);
  float inside = radius - length(p);
  float stroke = viewport.z;
  if (shape == 0u) inside = 1.1 * stroke - abs(length(p) - radius + 1.1 * stroke);
  if (shape == 3u) inside = 0.7 * stroke - abs(length(p) - radius + 0.7 * stroke);
  if (shape == 2u) {
    float arm = max(0.2 * radius, 0.8 * stroke);
    vec2 tip = vec2(0.7071) * (radius - arm);
    inside = arm - min(capsule(p, tip), capsule(p, vec2(tip.x, -tip.y)));
  }
  uint solid = shape & 7u;
  if (solid == 4u) inside = 0.8 * radius - max(abs(p.x), abs(p.y));
  if (solid == 5u) inside = 0.7071 * (radius - abs(p.x) - abs(p.y));
  if (solid == 6u) inside = min(0.5 * radius - p.y, dot(vec2(-0.866, 0.5), vec2(abs(p.x), p.y)) + 0.5 * radius);
  if (solid == 7u) {
    float arm = max(0.2 * radius, 0.8 * stroke);
    inside = arm - min(capsule(p, vec2(radius - arm, 0)), capsule(p, vec2(0, radius - arm)));
  }
  if (shape >= 8u) inside = 0.7 * stroke - abs(inside - 0.7 * stroke);
  float alpha = clamp(inside + 0.5, 0.0, 1.0) * mark_tint.a * opacity;
  if (alpha < 0.01) discard;
  colour = vec4(mark_tint.rgb * alpha, alpha);
}
