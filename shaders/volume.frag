#version 410 core
// Ω by ray marching: g = ±d/δ (the sign is the side), its boundaries are g = 1 (outer) and g = -1 (inner).
#include "frame.glsl"
#include "light.glsl"
in vec2 uv;
uniform sampler3D grid;
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
float g_at(float t) { return textureLod(grid, (origin + t * direction - box_lo) / (box_hi - box_lo), 0.0).r; }
float g_of(vec3 p) { return textureLod(grid, (p - box_lo) / (box_hi - box_lo), 0.0).r; }

vec3 gradient(vec3 p) {
  vec3 e = 0.9 * voxel;
  vec3 a = vec3(1, -1, -1), b = vec3(-1, -1, 1), c = vec3(-1, 1, -1), d = vec3(1, 1, 1);
  vec3 sum = a * g_of(p + a * e) + b * g_of(p + b * e) + c * g_of(p + c * e) + d * g_of(p + d * e);
  return sum / e;
}

void add(vec3 rgb, float alpha, float t) {
  if (colour.a == 0.0) depth = vec4(t * dot(direction, forward.xyz) + dot(origin - eye.xyz, forward.xyz));
  colour += vec4(rgb, 1.0) * alpha * (1.0 - colour.a);
}

// One boundary surface, met between a and b where g passes `level`.
void surface(float a, float ga, float b, float gb, float level, vec4 tint) {
  if (tint.a <= 0.0) return;
  for (int i = 0; i < (coarseness > 1.0 ? 1 : 4); ++i) {
    float m = mix(a, b, clamp((level - ga) / (gb - ga), 0.05, 0.95));
    float gm = g_at(m);
    if ((gm - level) * (ga - level) > 0.0) { a = m; ga = gm; } else { b = m; gb = gm; }
  }
  float t = mix(a, b, clamp((level - ga) / (gb - ga), 0.0, 1.0));
  vec3 p = origin + t * direction;
  vec3 n = normalize(gradient(p));
  float facing = dot(n, -direction);
  bool outside = facing * level > 0.0; // seen from outside of Ω
  vec3 rgb = lit(tint.rgb, facing < 0.0 ? -n : n, -direction) * (outside ? 1.0 : 0.8);
  // A thin shell is more opaque where it is seen edge-on.
  float alpha = 1.0 - pow(1.0 - min(tint.a, 0.999), 1.0 / max(abs(facing), 0.18));
  add(rgb, tint.a >= 0.995 ? 1.0 : alpha, t);
}

// Where the clip cuts through Ω, its thickness shows: tinted from side to side, the input's surface as a fine line.
void cap(float t) {
  float g = g_at(t);
  if (abs(g) >= 1.0) return;
  float strength = max(outer_tint.a, inner_tint.a);
  if (strength <= 0.0) return;
  vec3 p = origin + t * direction;
  vec3 rgb = mix(inner_tint.rgb, outer_tint.rgb, smoothstep(-0.5, 0.5, g));
  float pixels = delta * pixels_per_unit(p);
  float rim = 1.0 - smoothstep(0.6, 1.8, (1.0 - abs(g)) * pixels);
  float middle = smoothstep(3.0, 6.0, pixels) * (1.0 - smoothstep(0.3, 1.1, abs(g) * pixels));
  rgb = mix(rgb * 0.92, rgb * 0.55, max(0.8 * rim, 0.5 * middle));
  add(rgb, mix(clamp(0.25 + strength, 0.0, 0.75), 0.95, max(rim, middle)), t);
}

void march(float from, float to, bool cap_from, bool cap_to, float jitter) {
  if (from >= to) return;
  float smallest = min(voxel.x, min(voxel.y, voxel.z)) * 0.45 * coarseness;
  if (cap_from) cap(from);
  float t = from, before = from, g_before = g_at(from);
  bool known = true;
  t += smallest * jitter;
  for (int i = 0; i < max_steps && colour.a < 0.98; ++i) {
    bool last = t >= to;
    if (last) t = to;
    float jump = last ? 0.0 : textureLod(skip, skip_scale * (origin + t * direction - box_lo) / (box_hi - box_lo), 0.0).r;
    if (jump > 0.0) {
      t += jump;
      known = false;
      continue;
    }
    float g = g_at(t);
    if (known) {
      bool rising = g > g_before;
      bool meets_outer = (g_before - 1.0) * (g - 1.0) < 0.0, meets_inner = (g_before + 1.0) * (g + 1.0) < 0.0;
      if (rising && meets_inner) surface(before, g_before, t, g, -1.0, inner_tint);
      if (meets_outer) surface(before, g_before, t, g, 1.0, outer_tint);
      if (!rising && meets_inner) surface(before, g_before, t, g, -1.0, inner_tint);
    }
    if (last) break;
    before = t;
    g_before = g;
    known = true;
    t += max(abs(abs(g) - 1.0) * delta * 0.95, smallest);
  }
  if (cap_to && colour.a < 0.98) cap(to);
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
  float opaque_at = dot(hit.xyz / hit.w - origin, direction);
  bool behind_opaque = z < 1.0 && opaque_at < to;
  if (behind_opaque) to = opaque_at;
  if (from >= to) return;
  float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));

  if (clip_shape.x < 0.5) {
    march(from, to, false, false, jitter);
    return;
  }
  // The unflipped clip keeps one stretch [a, b] of the ray.
  float a = -1e30, b = 1e30;
  vec3 offset = origin - clip_point.xyz;
  float height = dot(offset, clip_normal.xyz), rate = dot(direction, clip_normal.xyz);
  if (clip_shape.x > 2.5) {
    float middle = -dot(offset, direction), disc = middle * middle - dot(offset, offset) + clip_point.w * clip_point.w;
    if (disc < 0.0) { a = 1e30; b = -1e30; }
    else { a = middle - sqrt(disc); b = middle + sqrt(disc); }
  } else {
    rate = abs(rate) < 1e-9 ? 1e-9 : rate;
    float upper = ((clip_shape.x > 1.5 ? clip_point.w : 0.0) - height) / rate;
    float lower = clip_shape.x > 1.5 ? (-clip_point.w - height) / rate : (rate > 0.0 ? -1e30 : 1e30);
    a = min(upper, lower);
    b = max(upper, lower);
  }
  if (clip_normal.w > 0.0) {
    march(max(from, a), min(to, b), a > from, b < to, jitter);
  } else if (a > b) {
    march(from, to, false, false, jitter);
  } else {
    march(from, min(to, a), false, a < to, jitter);
    if (colour.a < 0.98) march(max(from, b), to, b > from, false, jitter);
  }
}
