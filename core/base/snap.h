// Rounding of points to a grid, so that differences and exact predicates of them have bits to spare.
#pragma once

#include "base/geometry.h"

#include <cmath>

namespace isoscope {

/// The point with coordinates that are multiples of `unit`, a power of two; as it is where that is 0.
inline Vec3 snapped(Vec3 p, double unit) {
  if (!(unit > 0)) return p;
  return {std::round(p.x / unit) * unit, std::round(p.y / unit) * unit, std::round(p.z / unit) * unit};
}

} // namespace isoscope
