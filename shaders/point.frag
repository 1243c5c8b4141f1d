#version 410 core
// A disc where the point counts, a cross where it was dropped.
flat in vec3 colour_of;
flat in uint dropped;
flat in float radius;
flat in float fog;
uniform vec3 ground;
uniform float opacity;
uniform int smooth_edges; // 1: the alpha becomes coverage
layout(location = 0) out vec4 colour;

float capsule(vec2 p, vec2 tip) { return length(p - tip * clamp(dot(p, tip) / dot(tip, tip), -1.0, 1.0)); }

void main() {
  vec2 p = (gl_PointCoord - 0.5) * (2.0 * radius + 1.5);
  float distance_in = radius - length(p); // pixels inside the glyph
  if (dropped == 1u) {
    float arm = max(0.2 * radius, 0.6);
    vec2 tip = vec2(0.7071) * (radius - arm);
    distance_in = arm - min(capsule(p, tip), capsule(p, vec2(tip.x, -tip.y)));
  }
  float alpha = clamp(distance_in + 0.5, 0.0, 1.0) * opacity;
  if (alpha < 0.3) discard;
  float rim = dropped == 1u || radius < 2.5 ? 1.0 : 0.72 + 0.28 * clamp(distance_in - 0.4, 0.0, 1.0);
  colour = vec4(mix(colour_of * rim, ground, fog), smooth_edges == 1 ? alpha : 1.0);
}
