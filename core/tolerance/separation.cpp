// The nearest pair of triangles of two surfaces.
#include "tolerance/separation.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr std::uint32_t triangles_between_questions = 64;

/// The least that two boxes can be apart.
double box_distance(const Box3& a, const Box3& b) {
  Vec3 gap;
  for (int k = 0; k < 3; ++k) gap[k] = std::max({0.0, b.lo[k] - a.hi[k], a.lo[k] - b.hi[k]});
  return length(gap);
}

} // namespace

Separation find_separation(const ClosestPointIndex& first, const ClosestPointIndex& second,
                           const RunControl& control) {
  Separation best;
  SparsePoll poll(control, triangles_between_questions);
  ClosestPoint near;
  for (std::uint32_t t = 0; t < first.size() && !poll.cancelled(); ++t) {
    const Triangle3& triangle = first.triangle(TriangleId(t));
    near = second.closest_near(triangle[0], near.triangle);
    if (near.distance() < best.distance) best = {near.distance(), TriangleId(t)};
  }
  for (std::uint32_t t = 0; t < first.size() && !poll.cancelled(); ++t) {
    const Triangle3& triangle = first.triangle(TriangleId(t));
    const Box3 box = box_of(triangle);
    for (const TriangleId other : second.triangles_in(box.grown(best.distance))) {
      const Triangle3& candidate = second.triangle(other);
      if (box_distance(box, box_of(candidate)) >= best.distance) continue;
      const double d = disjoint_triangle_distance(triangle, candidate);
      if (d < best.distance) best = {d, TriangleId(t)};
    }
  }
  return best;
}

} // namespace isoscope
