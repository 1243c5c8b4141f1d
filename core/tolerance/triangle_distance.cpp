// Distances between points, segments and triangles.
#include "tolerance/closest_point.h"
#include "tolerance/triangle_point.h"

namespace isoscope {
namespace {

Vec3 closest_on_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double l2 = squared_length(ab);
  if (!(l2 > 0)) return a;
  const double t = dot(p - a, ab) / l2;
  if (t <= 0) return a;
  if (t >= 1) return b;
  return a + t * ab;
}

double squared_segment_distance(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double det = uu * vv - uv * uv;
  double best = std::min(
      {squared_length(closest_on_segment(a, c, d) - a), squared_length(closest_on_segment(b, c, d) - b),
       squared_length(closest_on_segment(c, a, b) - c), squared_length(closest_on_segment(d, a, b) - d)});
  if (det > 0) {
    const double s = (uv * vw - vv * uw) / det, t = (uu * vw - uv * uw) / det;
    if (s > 0 && s < 1 && t > 0 && t < 1) best = std::min(best, squared_length(w + s * u - t * v));
  }
  return best;
}

bool segment_crosses(Vec3 a, Vec3 b, const Triangle3& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double ha = dot(n, a - t[0]), hb = dot(n, b - t[0]);
  if (!((ha > 0) != (hb > 0)) || ha == hb) return false;
  const Vec3 x = a + (ha / (ha - hb)) * (b - a);
  for (int i = 0; i < 3; ++i)
    if (dot(n, cross(t[(i + 1) % 3] - t[i], x - t[i])) < 0) return false;
  return true;
}

} // namespace

Vec3 closest_point_on_edges(Vec3 p, const Triangle3& t) {
  Vec3 best = closest_on_segment(p, t[0], t[1]);
  for (const Vec3 q : {closest_on_segment(p, t[1], t[2]), closest_on_segment(p, t[2], t[0])})
    if (squared_length(q - p) < squared_length(best - p)) best = q;
  return best;
}

Vec3 closest_point_on_triangle(Vec3 p, const Triangle3& t) {
  return closest_point_inlined(p, t);
}

bool triangles_within(const Triangle3& a, const Triangle3& b, double r) {
  const double r2 = r * r;
  for (int i = 0; i < 3; ++i) {
    if (squared_length(closest_point_on_triangle(a[i], b) - a[i]) <= r2) return true;
    if (squared_length(closest_point_on_triangle(b[i], a) - b[i]) <= r2) return true;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (squared_segment_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]) <= r2) return true;
  for (int i = 0; i < 3; ++i)
    if (segment_crosses(a[i], a[(i + 1) % 3], b) || segment_crosses(b[i], b[(i + 1) % 3], a)) return true;
  return false;
}

double disjoint_triangle_distance(const Triangle3& a, const Triangle3& b) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    best = std::min(best, squared_length(closest_point_on_triangle(a[i], b) - a[i]));
    best = std::min(best, squared_length(closest_point_on_triangle(b[i], a) - b[i]));
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      best = std::min(best, squared_segment_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  return std::sqrt(best);
}

} // namespace isoscope
