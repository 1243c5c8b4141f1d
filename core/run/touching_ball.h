// The largest ball that lies on a wall of the input.
#pragma once

#include "base/geometry.h"

namespace isoscope {

/// Its radius, at most `most`: of a ball on the side of `direction`, a unit vector, that touches the wall at
/// `foot` and holds nothing else. Found by shrinking to what nearest(p) says is nearest to its centre p.
template <class Nearest>
double touching_radius(Vec3 foot, Vec3 direction, double most, const Nearest& nearest) {
  constexpr int most_steps = 40;
  constexpr double fits = 1 - 1e-6;
  double radius = most;
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 center = foot + radius * direction, to = nearest(center) - foot;
    if (squared_length(to - radius * direction) >= fits * fits * radius * radius) break;
    const double along = dot(to, direction);
    if (!(along > 0)) break; // it is touched at its own wall
    const double smaller = squared_length(to) / (2 * along);
    if (smaller >= fits * radius) break;
    radius = smaller;
  }
  return radius;
}

} // namespace isoscope
