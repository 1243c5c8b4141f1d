// The ground of the 2D section, with Ω's section softly tinted by side and contours of d.
#include "frame.glsl"
#include "bricks.glsl"
in vec2 uv;
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
  if (any(lessThan(p, box_lo)) || any(greaterThan(p, box_hi))) return;
  choose_grid(p);
  vec3 q = in_places(p);
  float g = value_at(q) * (is_signed == 1 ? 1.0 : side_at(q));
  float reach = level * delta * viewport.w; // pixels
  float pixels = (level - abs(g)) * delta * viewport.w; // inside Ω, to its boundary
  float cover = clamp(pixels + 0.5, 0.0, 1.0);
  vec4 tint = mix(inner_tint, outer_tint, smoothstep(-0.35, 0.35, g));
  float strength = tint.a <= 0.0 ? 0.0 : 0.16 + 0.30 * tint.a;
  float rim = tint.a <= 0.0 ? 0.0 : (1.0 - smoothstep(0.4, 1.4, abs(pixels - 0.7 * viewport.z))) * 0.75;
  float d = abs(g) / level, from_line = abs(fract(4.0 * d + 0.5) - 0.5) * 0.25 * reach / viewport.z;
  float line = tint.a <= 0.0 ? 0.0 : 0.35 * smoothstep(20.0, 44.0, reach / viewport.z) * (1.0 - smoothstep(0.3, 1.0, from_line)) * step(0.125, d) * step(d, 0.875);
  float a = max(max(strength * cover, rim), strength * cover + line * (1.0 - strength));
  colour = vec4(tint.rgb, 1.0) * a + ground * (1.0 - a);
}
