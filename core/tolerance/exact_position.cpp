// CGAL's predicates on doubles are exact.
#include "tolerance/exact_position.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>

namespace isoscope {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactPoint = Kernel::Point_3;

/// Ways nearly along an axis, whose boxes hold few triangles; where one meets an edge, the next is tried.
constexpr std::array<Vec3, 12> ways{{{1, .0137, .0089},
                                     {-1, .0111, -.0173},
                                     {.0149, 1, -.0101},
                                     {-.0093, -1, .0191},
                                     {.0163, .0127, 1},
                                     {-.0139, .0097, -1},
                                     {1, -.0313, .0241},
                                     {-1, -.0287, .0379},
                                     {-.0331, 1, .0269},
                                     {.0389, -1, -.0217},
                                     {-.0233, .0361, 1},
                                     {.0271, -.0317, -1}}};

ExactPoint point(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// Whether a segment crosses the inside of a triangle; nothing where it meets its border or one of its ends
/// lies in its plane.
std::optional<bool> crosses(const ExactPoint& p, const ExactPoint& q, const Triangle3& t) {
  const ExactPoint a = point(t[0]), b = point(t[1]), c = point(t[2]);
  const CGAL::Orientation at_p = CGAL::orientation(a, b, c, p), at_q = CGAL::orientation(a, b, c, q);
  if (at_p == at_q && at_p != CGAL::COPLANAR) return false;
  const CGAL::Orientation sides[3] = {CGAL::orientation(p, q, a, b), CGAL::orientation(p, q, b, c),
                                      CGAL::orientation(p, q, c, a)};
  const bool left = std::count(std::begin(sides), std::end(sides), CGAL::POSITIVE) > 0;
  const bool right = std::count(std::begin(sides), std::end(sides), CGAL::NEGATIVE) > 0;
  if (left && right) return false; // the line passes beside it
  if (at_p == CGAL::COPLANAR || at_q == CGAL::COPLANAR) return std::nullopt;
  if (std::count(std::begin(sides), std::end(sides), CGAL::COPLANAR) > 0) return std::nullopt;
  return true;
}

} // namespace

bool triangles_meet(const Triangle3& facet, const Triangle3& wall) {
  const Kernel::Triangle_3 other(point(wall[0]), point(wall[1]), point(wall[2]));
  const ExactPoint a = point(facet[0]), b = point(facet[1]), c = point(facet[2]);
  if (!CGAL::collinear(a, b, c)) return CGAL::do_intersect(Kernel::Triangle_3(a, b, c), other);
  const auto segment_meets = [&](const ExactPoint& s, const ExactPoint& t) {
    return s == t ? other.has_on(s) : CGAL::do_intersect(Kernel::Segment_3(s, t), other);
  };
  return segment_meets(a, b) || segment_meets(b, c) || segment_meets(c, a);
}

std::optional<std::vector<TriangleId>> crossed_on_the_way_out(Vec3 p, const ClosestPointIndex& index,
                                                              const std::function<bool(TriangleId)>& counts) {
  Box3 all = index.bounds();
  all.add(p);
  const double far = 2 * all.longest_edge();
  for (const Vec3 way : ways) {
    const Vec3 end = p + far * way;
    Box3 box;
    box.add(p);
    box.add(end);
    std::vector<TriangleId> crossed;
    bool generic = true;
    for (const TriangleId t : index.triangles_in(box)) {
      if (!counts(t)) continue;
      const auto met = crosses(point(p), point(end), index.triangle(t));
      generic = generic && met.has_value();
      if (!generic) break;
      if (*met) crossed.push_back(t);
    }
    if (generic) return crossed;
  }
  return std::nullopt;
}

} // namespace isoscope
