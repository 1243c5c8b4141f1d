// How often closed surfaces wind around points, from their facets one by one: no facet needs to know of
// another.
#pragma once

#include "base/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace isoscope {

/// What a facet adds to the number of times that its surface winds around p, told by the ray from p along x:
/// +1 where that leaves through the facet, -1 where it enters, else 0. Exact, as if p were moved by the least
/// bit along y, and by far less along z: the facets of a closed oriented surface, none of which holds p, add
/// up to its winding number.
int signed_crossing(const Triangle3& facet, Vec3 p);

/// Sums that up for many points at once.
class RayWinding {
 public:
  static constexpr std::size_t no_point = ~std::size_t{0};
  explicit RayWinding(std::vector<Vec3> points);
  /// `except`: a point for which the facet does not count.
  void add(const Triangle3& facet, std::size_t except = no_point);
  /// By point, in the order they were given.
  std::vector<int> windings() const;

 private:
  struct Ray {
    Vec3 from;
    std::size_t point = 0;
    int winding = 0;
  };
  std::vector<Ray> rays_; ///< ascending by y
};

} // namespace isoscope
