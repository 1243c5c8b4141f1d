// Distances of a facet to a surface by samples, to hold proven bounds against.
#pragma once

#include "tolerance/closest_point.h"

#include <algorithm>

namespace isoscope::testing {

/// The largest at the corners of n² congruent pieces.
inline double sampled_maximum(const ClosestPointIndex& index, const Triangle3& t, int n) {
  double largest = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      largest = std::max(largest, index.distance(t[0] + (static_cast<double>(i) / n) * (t[1] - t[0]) +
                                                 (static_cast<double>(j) / n) * (t[2] - t[0])));
  return largest;
}

} // namespace isoscope::testing
