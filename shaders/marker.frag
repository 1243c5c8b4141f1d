#version 410 core
// Ring, disc, cross or thin circle, with smooth edges.
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
  float alpha = clamp(inside + 0.5, 0.0, 1.0) * mark_tint.a * opacity;
  if (alpha < 0.01) discard;
  colour = vec4(mark_tint.rgb * alpha, alpha);
}
