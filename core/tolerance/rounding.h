// What computed distances may be off by.
#pragma once

#include "base/geometry.h"

namespace isoscope {

/// Bound of the error that `roundings` operations make on numbers below the largest coordinate of two boxes.
inline double rounding_bound(const Box3& a, const Box3& b, int roundings) {
  double largest = 0;
  for (const Box3& box : {a, b})
    for (int k = 0; k < 3; ++k) largest = std::max({largest, std::abs(box.lo[k]), std::abs(box.hi[k])});
  return roundings * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace isoscope
