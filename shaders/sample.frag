#version 410 core
// The glyph says the class (disc good, cross bad, diamond over the rim), its filling the side (full outer, ring inner).
flat in uint outer;
flat in float radius;
flat in float fog;
uniform vec3 tint;
uniform vec3 ground;
uniform int glyph;        // 0 disc, 1 cross, 2 diamond
uniform float opacity;
uniform int smooth_edges; // 1: the alpha becomes coverage
layout(location = 0) out vec4 colour;

float capsule(vec2 p, vec2 tip) { return length(p - tip * clamp(dot(p, tip) / dot(tip, tip), -1.0, 1.0)); }

void main() {
  vec2 p = (gl_PointCoord - 0.5) * (2.0 * radius + 1.5);
  float distance_in;  // pixels inside the glyph
  float small = 1.0 - smoothstep(1.6, 2.4, radius);
  if (glyph == 2) {
    float diamond = 0.7071 * (radius - abs(p.x) - abs(p.y));
    float stroke = max(0.24 * radius, 0.6);
    distance_in = mix(stroke - abs(diamond - stroke), radius - length(p), small);
  } else if (glyph == 1) {
    float arm = max(0.26 * radius, 0.7);
    vec2 tip = vec2(0.7071) * (radius - arm);
    distance_in = arm - min(capsule(p, tip), capsule(p, vec2(tip.x, -tip.y)));
    if (outer == 0u) distance_in = max(distance_in, max(0.12 * radius, 0.5) - abs(length(p) - radius + 0.6));
    distance_in = mix(distance_in, radius - length(p), small);
  } else {
    distance_in = radius - length(p);
    if (outer == 0u) {
      float ring = max(0.22 * radius, 0.6);
      distance_in = mix(ring - abs(length(p) - radius + ring), distance_in, small);
    }
  }
  float alpha = clamp(distance_in + 0.5, 0.0, 1.0) * opacity;
  if (alpha < 0.3) discard;
  float rim = glyph != 0 || radius < 2.5 || outer == 0u ? 1.0 : 0.72 + 0.28 * clamp(distance_in - 0.4, 0.0, 1.0);
  float bulb = glyph != 0 ? 1.0 : 1.06 - 0.14 * length(p - vec2(-0.3, -0.3) * radius) / max(radius, 1.0);
  colour = vec4(mix(tint * rim * bulb, ground, fog), smooth_edges == 1 ? alpha : 1.0);
}
