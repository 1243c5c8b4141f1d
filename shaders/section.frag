#version 410 core
// The ground of the 2D section, with Ω's section softly tinted by side.
#include "frame.glsl"
in vec2 uv;
uniform sampler3D grid;
uniform vec3 box_lo, box_hi;
uniform sampler3D sides; // +1 or -1, where is_signed is 0
uniform int is_signed;
uniform float level;
uniform float delta;
uniform vec4 outer_tint, inner_tint; // a: opacity
uniform int with_volume;
uniform vec3 top, bottom;
uniform vec2 rows; // the frame in the picture: heights of its lower and upper rim
uniform float opacity;
out vec4 colour;
void main() {
  vec4 ground = vec4(mix(bottom, top, smoothstep(0.0, 1.0, mix(rows.x, rows.y, uv.y))), 1.0) * opacity;
  colour = ground;
  if (with_volume == 0) return;
  vec4 near_h = inverse_view_projection * vec4(uv * 2.0 - 1.0, -1.0, 1.0);
  vec3 p = near_h.xyz / near_h.w;
  p -= clip_normal.xyz * dot(p - clip_point.xyz, clip_normal.xyz);
  vec3 at = (p - box_lo) / (box_hi - box_lo);
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return;
  float g = textureLod(grid, at, 0.0).r;
  if (is_signed == 0) g *= textureLod(sides, at, 0.0).r < 0.0 ? -1.0 : 1.0;
  float pixels = (level - abs(g)) * delta * viewport.w; // inside Ω, to its boundary
  float cover = clamp(pixels + 0.5, 0.0, 1.0);
  vec4 tint = mix(inner_tint, outer_tint, smoothstep(-0.35, 0.35, g));
  float strength = tint.a <= 0.0 ? 0.0 : 0.16 + 0.30 * tint.a;
  float rim = tint.a <= 0.0 ? 0.0 : (1.0 - smoothstep(0.4, 1.4, abs(pixels - 0.7 * viewport.z))) * 0.75;
  float a = max(strength * cover, rim);
  colour = vec4(tint.rgb, 1.0) * a + ground * (1.0 - a);
}
