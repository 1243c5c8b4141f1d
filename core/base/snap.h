// Rounding of points to a grid, so that differences and exact predicates of them have bits to spare.
#pragma once

#include "base/geometry.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

/// The grid for points of a model of this size within `space`: 2^-40 of the size. Where doubles are so far
/// apart there that midpoints of such points are none, 16 times their spacing.
inline double snap_unit(double size, const Box3& space) {
  const double unit = std::ldexp(1.0, std::ilogb(size) - 40);
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(space.lo[axis]), std::abs(space.hi[axis])});
  const double spacing = std::ldexp(1.0, std::ilogb(farthest) - 52);
  return unit < 2 * spacing ? 16 * spacing : unit;
}

/// The point with coordinates that are multiples of `unit`, a power of two; as it is where that is 0.
inline Vec3 snapped(Vec3 p, double unit) {
  if (!(unit > 0)) return p;
  return {std::round(p.x / unit) * unit, std::round(p.y / unit) * unit, std::round(p.z / unit) * unit};
}

} // namespace isoscope
