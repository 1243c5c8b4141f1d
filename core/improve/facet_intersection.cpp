// CGAL's filtered exact predicates, by number of shared vertices.
#include "improve/facet_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

namespace isoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(Vec3 v) {
  return {v.x, v.y, v.z};
}

Kernel::Triangle_3 triangle(const Triangle3& t) {
  return {point(t[0]), point(t[1]), point(t[2])};
}

/// Whether the edge opposite to the corner `k` of `t` meets the other triangle.
bool opposite_edge_meets(const Triangle3& t, std::size_t k, const Triangle3& other) {
  const Kernel::Segment_3 edge(point(t[(k + 1) % 3]), point(t[(k + 2) % 3]));
  return CGAL::do_intersect(edge, triangle(other));
}

} // namespace

bool intersect_properly(const IndexedTriangle& a, const IndexedTriangle& b) {
  std::array<std::size_t, 3> in_a{}, in_b{};
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a.ids[i] == b.ids[j] && shared < 3) in_a[shared] = i, in_b[shared] = j, ++shared;
  if (shared == 0) return CGAL::do_intersect(triangle(a.points), triangle(b.points));
  if (shared == 1)
    return opposite_edge_meets(a.points, in_a[0], b.points) ||
           opposite_edge_meets(b.points, in_b[0], a.points);
  if (shared > 2) return true;
  const auto p = point(a.points[in_a[0]]), q = point(a.points[in_a[1]]),
             r = point(a.points[3 - in_a[0] - in_a[1]]), s = point(b.points[3 - in_b[0] - in_b[1]]);
  return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR &&
         CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

bool is_degenerate(const Triangle3& t) {
  return CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
}

} // namespace isoscope
