// What computed distances may be off by.
#pragma once

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {

/// What a computed distance, circumradius bound or repeatedly rounded midpoint may be off by. Each comes from
/// fewer than 32 operations on numbers below the largest coordinate M, and midpoints along one path of at
/// most 120 bisections drift by at most one rounding a level, so (32 + 32 + 120) u M is enough; 256 leaves
/// room.
constexpr int bound_roundings = 256;

/// Bound of the error that `roundings` operations make on numbers below the largest coordinate of two boxes.
inline double rounding_bound(const Box3& a, const Box3& b, int roundings) {
  double largest = 0;
  for (const Box3& box : {a, b})
    for (int k = 0; k < 3; ++k) largest = std::max({largest, std::abs(box.lo[k]), std::abs(box.hi[k])});
  return roundings * std::numeric_limits<double>::epsilon() * largest;
}

/// Half the diagonal of a unit cube, rounded up generously: what is said of a whole cell has to be certain,
/// also after the rounding of distances and centres.
constexpr double half_diagonal = 0.86602540379 * (1 + 1e-7);

} // namespace isoscope
