// Signs of the projection along x, perturbed where a ray meets an edge.
#include "tolerance/ray_winding.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace isoscope {
namespace {

using RayKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int sign(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// On which side of the line from a to b, seen along x, p lies; 0 only where a and b are the same there.
int side_of_line(Vec3 a, Vec3 b, Vec3 p) {
  const auto flat = [](Vec3 v) { return RayKernel::Point_2(v.y, v.z); };
  if (const int exact = CGAL::orientation(flat(a), flat(b), flat(p)); exact != 0) return exact;
  if (a.z != b.z) return sign(a.z - b.z);
  return sign(b.y - a.y);
}

} // namespace

int signed_crossing(const Triangle3& t, Vec3 p) {
  const int turn = side_of_line(t[0], t[1], p);
  if (turn == 0 || side_of_line(t[1], t[2], p) != turn || side_of_line(t[2], t[0], p) != turn) return 0;
  const auto solid = [](Vec3 v) { return RayKernel::Point_3(v.x, v.y, v.z); };
  const int above = CGAL::orientation(solid(t[0]), solid(t[1]), solid(t[2]), solid(p));
  return above == -turn ? turn : 0;
}

RayWinding::RayWinding(std::vector<Vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) rays_.push_back({points[i], i});
  std::sort(rays_.begin(), rays_.end(), [](const Ray& a, const Ray& b) {
    return a.from.y != b.from.y ? a.from.y < b.from.y : a.point < b.point;
  });
}

void RayWinding::add(const Triangle3& facet, std::size_t except) {
  const Box3 box = box_of(facet);
  const auto first = std::lower_bound(rays_.begin(), rays_.end(), box.lo.y,
                                      [](const Ray& r, double y) { return r.from.y < y; });
  for (auto ray = first; ray != rays_.end() && ray->from.y <= box.hi.y; ++ray) {
    const Vec3 p = ray->from;
    if (p.z < box.lo.z || p.z > box.hi.z || p.x > box.hi.x || ray->point == except) continue;
    ray->winding += signed_crossing(facet, p);
  }
}

std::vector<int> RayWinding::windings() const {
  std::vector<int> sums(rays_.size());
  for (const Ray& r : rays_) sums[r.point] = r.winding;
  return sums;
}

} // namespace isoscope
