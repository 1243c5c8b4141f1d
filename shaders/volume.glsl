// Ω by ray marching: g = ±φ/δ (the sign is the side), its boundaries are g = level (outer) and g = -level (inner). Where φ is
// nowhere 0 between the sides the bricks hold |g|, and others the sides: between them g would pass through 0.
// HAZE: between the boundaries a haze, thicker or thinner by g, tells how much of Ω a ray goes through.
// MOVING: both boundaries and plain cuts alone, for frames that are gone at once.
// Software drivers run both sides of every branch: what a frame does not need is left out of its program, fetches stand
// outside of branches where they can, and a loop that ends early is what saves time.
#include "frame.glsl"
#include "light.glsl"
#include "bricks.glsl"
#include "contours.glsl"
in vec2 uv;
uniform float level;
uniform sampler2D scene_depth;
uniform float delta;
uniform vec4 outer_tint, inner_tint; // a: opacity
uniform vec3 haze;             // optical depth of a way of δ at g = level, 0, -level
uniform float jitter_phase;    // in [0, 1): frames that are averaged start differently
uniform float ray_pixels;      // how many pixels of the view lie between two rays
uniform int max_steps;
uniform float coarseness;      // 1 at rest, larger while moving
layout(location = 0) out vec4 colour; // premultiplied
layout(location = 1) out vec4 depth;

vec3 origin, direction;
vec3 q_origin, q_direction, inverse_q; // the ray in places
vec3 q_at(float t) { return q_origin + t * q_direction; }

// The direction in which g grows; 0 where it does not.
vec3 rise(vec3 q) {
  float e = 0.9 / 7.0; // of a voxel
  vec3 a = vec3(1, -1, -1), b = vec3(-1, -1, 1), c = vec3(-1, 1, -1), d = vec3(1, 1, 1);
  vec3 sum = a * value_at(q + a * e) + b * value_at(q + b * e) + c * value_at(q + c * e) + d * value_at(q + d * e);
  return sum / max(length(sum), 1e-12);
}

void add(vec3 rgb, float alpha, float t) {
  if (colour.a == 0.0) depth = vec4(t * dot(direction, forward.xyz) + dot(origin - eye.xyz, forward.xyz));
  colour += vec4(rgb, 1.0) * alpha * (1.0 - colour.a);
}

// The boundary where the grid's value is `value`.
void surface(float t, float value) {
  vec3 q = q_at(t);
  bool outer = value * side_at(q) > 0.0;
  vec4 tint = outer ? outer_tint : inner_tint;
  if (tint.a <= 0.0) return;
  vec3 n = rise(q);
  float facing = dot(n, -direction), across = abs(facing);
  bool outside = facing * value > 0.0; // seen from outside of Ω
  vec3 rgb = lit(tint.rgb, facing < 0.0 ? -n : n, -direction) * (outside ? 1.0 : 0.8);
  // The outer boundary is clear where one looks straight through it and shows at its rim, as glass does; the inner one is
  // a thin shell, more opaque where it is seen edge-on.
  float edge_on = pow(1.0 - across, 2.5);
  float alpha = outer ? mix(0.5 * tint.a, min(0.85, 2.6 * tint.a), edge_on) : 1.0 - pow(1.0 - tint.a, 1.0 / max(across, 0.25));
  if (tint.a >= 0.995) alpha = 1.0;
  add(rgb, alpha, t);
}

#ifdef HAZE
// What a stretch of Ω that ends at t takes from the light behind it.
void add_haze(float g, float stretch, float t) {
  if (abs(g) >= 1.02 * level) return;
  float s = clamp(g * side_at(q_at(t)) / level, -1.0, 1.0);
  float density = s > 0.0 ? mix(haze.y, haze.x, s) : mix(haze.y, haze.z, -s);
  vec3 rgb = mix(inner_tint.rgb, outer_tint.rgb, smoothstep(-0.6, 0.6, s));
  add(rgb * 0.92, 1.0 - exp(-density * stretch / delta), t);
}
#else
void add_haze(float g, float stretch, float t) {}
#endif

// Where the clip cuts through Ω, its thickness shows: tinted from side to side with contours of d, the input's surface a line.
void cap(float t) {
  vec3 q = q_at(t), p = origin + t * direction;
  float g = value_at(q), strength = max(outer_tint.a, inner_tint.a);
  if (abs(g) >= level || strength <= 0.0) return;
#ifdef MOVING
  float slope = 1.0;
#else
  vec3 cut = clip_shape.x > 2.5 ? normalize(p - clip_point.xyz) : clip_normal.xyz, n = rise(q);
  float slope = max(length(n - dot(n, cut) * cut), 0.2);
#endif
  vec4 face = band(g * side_at(q) / level, level * delta * pixels_per_unit(p) / slope, inner_tint.rgb, outer_tint.rgb);
  add(face.rgb, clamp(face.a * (0.35 + 0.65 * clamp(0.6 + strength, 0.0, 1.0)), 0.0, 1.0), t);
}

// What the last stretch ended with, where the next one goes on from there; what was crossed between two lattices shows.
float g_last;
bool goes_on = false;

void march(float from, float to, bool cap_from, bool cap_to, float jitter) {
  if (from >= to) return;
  // Neither finer than what the picture shows nor coarser than what Ω takes: it is at least twice `level` thick. A moving
  // frame sees also by the change of sides that it was crossed.
#ifdef MOVING
  float least = 0.4, most = is_signed == 1 ? 4.0 : 0.9;
#else
  float least = 0.35, most = 0.9;
#endif
  float pixel = ray_pixels / max(pixels_per_unit(origin + from * direction), 1e-20);
  float fine = min(max(max(0.45 / 7.0 * side_of_place(), least * delta), 0.4 * pixel) * coarseness, most * level * delta);
  float beyond = 4e-3 * side_of_place(); // the rim of a place
  if (cap_from && from < to) cap(from);
  float before = from, g_before = goes_on ? g_last : value_at(q_at(from)), t = min(from + fine * jitter * float(!cap_from), to);
  for (int hit = 0; hit < 8; ++hit) {
    float g = g_before, value = 0.0;
    bool end = from >= to;
    for (int i = 0; i < max_steps && !end; ++i) {
      vec3 q = q_at(t), place = place_at(q);
      uint entry = entry_at(place);
      g = value_in(q, place, entry);
      bool meets_outer = (g_before - level) * (g - level) < 0.0 && (outer_tint.a > 0.0 || is_signed == 0);
      bool meets_inner = (g_before + level) * (g + level) < 0.0 && inner_tint.a > 0.0;
      if (meets_outer || meets_inner) {
        value = meets_outer && (!meets_inner || g < g_before) ? level : -level;
        break;
      }
      add_haze(0.5 * (g + g_before), t - before, t);
      end = t >= to || colour.a > 0.98;
      before = t;
      g_before = g;
      // Just beyond what the distance proves empty, so that a surface is crossed at once; or out of the empty places.
      float rings = free_places(entry), step_in = abs(abs(g) - level) * delta * 0.9 + fine;
      vec3 leave = (place + mix(vec3(1.0 - rings), vec3(rings), greaterThan(q_direction, vec3(0.0))) - q) * inverse_q;
#ifdef HAZE
      if (abs(g) < level) step_in = min(step_in, 0.5 * delta);
#endif
      t = min(t + max(step_in, rings > 0.0 ? min(leave.x, min(leave.y, leave.z)) + beyond : 0.0), to);
    }
    if (value == 0.0) break;
    // Both ends read the same bricks as the steps do: what was crossed lies between them.
    float far = t, g_far = g, met = mix(before, t, clamp((value - g_before) / (g - g_before), 0.0, 1.0));
#ifndef MOVING
    float near = before, g_near = g_before;
    for (int k = 0; k < 3; ++k) {
      float g_met = value_at(q_at(met));
      bool passed = (g_met - value) * (g_far - value) > 0.0;
      near = passed ? near : met;
      g_near = passed ? g_near : g_met;
      far = passed ? met : far;
      g_far = passed ? g_met : g_far;
      float part = abs(g_far - g_near) < 1e-6 ? 0.5 : clamp((value - g_near) / (g_far - g_near), 0.0, 1.0);
      met = mix(near, far, k == 1 ? 0.5 : part);
    }
#endif
    add_haze(0.5 * (value + g_before), met - before, met);
    surface(met, value);
    before = met;
    g_before = value + (g > g_before ? 1e-4 : -1e-4);
    if (colour.a > 0.98) return;
  }
  g_last = g_before;
  goes_on = true;
  if (cap_to && from < to && colour.a < 0.98) cap(to);
}

// The ray in the lattice that is chosen.
void take_lattice() {
  q_origin = in_places(origin);
  q_direction = direction / side_of_place();
  q_direction = mix(q_direction, vec3(1e-12), lessThan(abs(q_direction), vec3(1e-12)));
  inverse_q = 1.0 / q_direction;
}

#ifdef DETAIL
// Before the part in finer voxels, in it, and behind it.
void march_all(float from, float to, bool cap_from, bool cap_to, float jitter) {
  vec3 to_lo = (detail_box_lo + detail_rim() - origin) / direction, to_hi = (detail_box_hi - detail_rim() - origin) / direction;
  vec3 t_in = min(to_lo, to_hi), t_out = max(to_lo, to_hi);
  float near = clamp(max(t_in.x, max(t_in.y, t_in.z)), from, to), far = clamp(min(t_out.x, min(t_out.y, t_out.z)), from, to);
  if (near >= far) near = far = to;
  goes_on = false;
  for (int part = 0; part < 3; ++part) {
    in_detail = part == 1;
    take_lattice();
    float start = part == 0 ? from : part == 1 ? near : far, stop = part == 0 ? near : part == 1 ? far : to;
    march(start, stop, cap_from && start <= from, cap_to && stop >= to, jitter);
    if (colour.a > 0.98) return;
  }
}
#else
void march_all(float from, float to, bool cap_from, bool cap_to, float jitter) {
  goes_on = false;
  march(from, to, cap_from, cap_to, jitter);
}
#endif

void main() {
  colour = vec4(0.0);
  depth = vec4(0.0);
  vec2 ndc = uv * 2.0 - 1.0;
  vec4 near_h = inverse_view_projection * vec4(ndc, -1.0, 1.0), far_h = inverse_view_projection * vec4(ndc, 1.0, 1.0);
  vec3 near_p = near_h.xyz / near_h.w, far_p = far_h.xyz / far_h.w;
  origin = near_p;
  direction = normalize(far_p - near_p);
  take_lattice();
  vec3 to_lo = (box_lo - origin) / direction, to_hi = (box_hi - origin) / direction;
  vec3 t_in = min(to_lo, to_hi), t_out = max(to_lo, to_hi);
  float from = max(max(t_in.x, max(t_in.y, t_in.z)), 0.0), to = min(t_out.x, min(t_out.y, t_out.z));
  float z = texture(scene_depth, uv).r;
  vec4 hit = inverse_view_projection * vec4(ndc, z * 2.0 - 1.0, 1.0);
  if (z < 1.0) to = min(to, dot(hit.xyz / hit.w - origin, direction));
  if (from >= to) return;
  float jitter = fract(jitter_phase + 52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));

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
    march_all(start, stop, cap_start, cap_stop, jitter);
    if (colour.a > 0.98) break;
  }
}
