#version 410 core
// Ω by ray marching: g = ±φ/δ (the sign is the side), its boundaries are g = level (outer) and g = -level (inner). Where φ is
// 0 between the sides the grid holds g; else it holds |g|, and another one the sides: between them g would pass through 0.
#include "frame.glsl"
#include "light.glsl"
in vec2 uv;
uniform sampler3D grid;
uniform sampler3D sides;       // +1 or -1, where is_signed is 0
uniform int is_signed;
uniform float level;
uniform sampler3D skip;        // scene units that may be crossed without meeting Ω
uniform sampler2D scene_depth;
uniform vec3 box_lo, box_hi;
uniform vec3 skip_scale;       // of the grid's texture coordinates to those of the blocks
uniform vec3 voxel;            // scene units
uniform float delta;
uniform vec4 outer_tint, inner_tint; // a: opacity
uniform int max_steps;
uniform float coarseness;      // 1 at rest, larger while moving
layout(location = 0) out vec4 colour; // premultiplied
layout(location = 1) out vec4 depth;

vec3 origin, direction;
// Software drivers run both sides of every branch: fetches stand outside of branches where they can, and a loop that ends
// early is what saves time.
vec3 at(float t) { return (origin + t * direction - box_lo) / (box_hi - box_lo); }
float g_at(float t) { return textureLod(grid, at(t), 0.0).r; }
float g_of(vec3 p) { return textureLod(grid, (p - box_lo) / (box_hi - box_lo), 0.0).r; }

vec3 gradient(vec3 p) {
  vec3 e = 0.9 * voxel;
  vec3 a = vec3(1, -1, -1), b = vec3(-1, -1, 1), c = vec3(-1, 1, -1), d = vec3(1, 1, 1);
  vec3 sum = a * g_of(p + a * e) + b * g_of(p + b * e) + c * g_of(p + c * e) + d * g_of(p + d * e);
  return sum / e;
}

float side_at(float t) { return is_signed == 1 ? 1.0 : (textureLod(sides, at(t), 0.0).r < 0.0 ? -1.0 : 1.0); }

void add(vec3 rgb, float alpha, float t) {
  if (colour.a == 0.0) depth = vec4(t * dot(direction, forward.xyz) + dot(origin - eye.xyz, forward.xyz));
  colour += vec4(rgb, 1.0) * alpha * (1.0 - colour.a);
}

// The boundary where the grid's value is `value`.
void surface(float t, float value) {
  vec4 tint = value * side_at(t) > 0.0 ? outer_tint : inner_tint;
  if (tint.a <= 0.0) return;
  vec3 n = normalize(gradient(origin + t * direction));
  float facing = dot(n, -direction);
  bool outside = facing * value > 0.0; // seen from outside of Ω
  vec3 rgb = lit(tint.rgb, facing < 0.0 ? -n : n, -direction) * (outside ? 1.0 : 0.8);
  // A thin shell is more opaque where it is seen edge-on.
  float alpha = tint.a >= 0.995 ? 1.0 : 1.0 - pow(1.0 - tint.a, 1.0 / max(abs(facing), 0.18));
  add(rgb, alpha, t);
}

// Where the clip cuts through Ω, its thickness shows: tinted from side to side, the input's surface as a fine line.
void cap(float t, float g) {
  float strength = max(outer_tint.a, inner_tint.a);
  if (abs(g) >= level || strength <= 0.0) return;
  g *= side_at(t) / level;
  vec3 rgb = mix(inner_tint.rgb, outer_tint.rgb, smoothstep(-0.5, 0.5, g));
  float pixels = level * delta * pixels_per_unit(origin + t * direction);
  float rim = 1.0 - smoothstep(0.6, 1.8, (1.0 - abs(g)) * pixels);
  float middle = float(is_signed) * smoothstep(3.0, 6.0, pixels) * (1.0 - smoothstep(0.3, 1.1, abs(g) * pixels));
  rgb = mix(rgb * 0.92, rgb * 0.55, max(0.8 * rim, 0.5 * middle));
  add(rgb, mix(clamp(0.25 + strength, 0.0, 0.75), 0.95, max(rim, middle)), t);
}

void march(float from, float to, bool cap_from, bool cap_to, float jitter) {
  float smallest = min(voxel.x, min(voxel.y, voxel.z)) * 0.45 * coarseness;
  float before = from, g_before = g_at(from);
  if (cap_from && from < to) cap(from, g_before);
  float t = min(from + smallest * jitter, to);
  for (int hit = 0; hit < 8; ++hit) {
    float g = g_before, value = 0.0;
    bool end = from >= to;
    for (int i = 0; i < max_steps && !end; ++i) {
      vec3 here = at(t);
      g = textureLod(grid, here, 0.0).r;
      float jump = textureLod(skip, skip_scale * here, 0.0).r;
      bool meets_outer = (g_before - level) * (g - level) < 0.0 && (outer_tint.a > 0.0 || is_signed == 0);
      bool meets_inner = (g_before + level) * (g + level) < 0.0 && inner_tint.a > 0.0;
      if (meets_outer || meets_inner) {
        value = meets_outer && (!meets_inner || g < g_before) ? level : -level;
        break;
      }
      end = t >= to;
      before = t;
      g_before = g;
      // Just beyond what the distance proves empty, so that a surface is crossed at once.
      t = min(t + max(jump, abs(abs(g) - level) * delta * 0.9 + smallest), to);
    }
    if (value == 0.0) break;
    float met = mix(before, t, clamp((value - g_before) / (g - g_before), 0.0, 1.0));
    if (coarseness <= 1.0) {
      float g_met = g_at(met);
      bool beyond = (g_met - value) * (g - value) > 0.0;
      float a = beyond ? before : met, ga = beyond ? g_before : g_met, b = beyond ? met : t, gb = beyond ? g_met : g;
      met = mix(a, b, abs(gb - ga) < 1e-6 ? 0.5 : clamp((value - ga) / (gb - ga), 0.0, 1.0));
    }
    surface(met, value);
    before = met;
    g_before = value + (g > g_before ? 1e-4 : -1e-4);
    if (colour.a > 0.98) return;
  }
  float g_end = g_at(to);
  if (cap_to && from < to && colour.a < 0.98) cap(to, g_end);
}

void main() {
  colour = vec4(0.0);
  depth = vec4(0.0);
  vec2 ndc = uv * 2.0 - 1.0;
  vec4 near_h = inverse_view_projection * vec4(ndc, -1.0, 1.0), far_h = inverse_view_projection * vec4(ndc, 1.0, 1.0);
  vec3 near_p = near_h.xyz / near_h.w, far_p = far_h.xyz / far_h.w;
  origin = near_p;
  direction = normalize(far_p - near_p);
  vec3 to_lo = (box_lo - origin) / direction, to_hi = (box_hi - origin) / direction;
  vec3 t_in = min(to_lo, to_hi), t_out = max(to_lo, to_hi);
  float from = max(max(t_in.x, max(t_in.y, t_in.z)), 0.0), to = min(t_out.x, min(t_out.y, t_out.z));
  float z = texture(scene_depth, uv).r;
  vec4 hit = inverse_view_projection * vec4(ndc, z * 2.0 - 1.0, 1.0);
  if (z < 1.0) to = min(to, dot(hit.xyz / hit.w - origin, direction));
  if (from >= to) return;
  float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));

  // The unflipped clip keeps one stretch [a, b] of the ray; flipped, what is before and after it.
  float a = -1e30, b = 1e30;
  vec3 offset = origin - clip_point.xyz;
  float height = dot(offset, clip_normal.xyz), rate = dot(direction, clip_normal.xyz);
  rate = abs(rate) < 1e-9 ? 1e-9 : rate;
  if (clip_shape.x > 2.5) {
    float middle = -dot(offset, direction), disc = middle * middle - dot(offset, offset) + clip_point.w * clip_point.w;
    a = disc < 0.0 ? 1e30 : middle - sqrt(disc);
    b = disc < 0.0 ? -1e30 : middle + sqrt(disc);
  } else if (clip_shape.x > 0.5) {
    float upper = ((clip_shape.x > 1.5 ? clip_point.w : 0.0) - height) / rate;
    float lower = clip_shape.x > 1.5 ? (-clip_point.w - height) / rate : (rate > 0.0 ? -1e30 : 1e30);
    a = min(upper, lower);
    b = max(upper, lower);
  }
  bool flipped = clip_shape.x > 0.5 && clip_normal.w < 0.0;
  int parts = flipped ? 2 : 1;
  for (int part = 0; part < parts; ++part) {
    bool whole = flipped && a > b && part == 0;
    float start = flipped ? (part == 0 ? from : max(from, a > b ? to : b)) : max(from, a);
    float stop = flipped ? (part == 0 && !whole ? min(to, a) : to) : min(to, b);
    bool cap_start = flipped ? part == 1 && b > from : a > from;
    bool cap_stop = flipped ? part == 0 && !whole && a < to : b < to;
    march(start, stop, cap_start, cap_stop, jitter);
    if (colour.a > 0.98) break;
  }
}
