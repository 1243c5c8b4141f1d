// How far an input is from the mesh that stands for it: proven bounds of the one-sided Hausdorff distance.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"

#include <limits>

namespace isoscope {

/// Bounds of the largest distance from the points of one surface to another; nothing proven by default.
struct DistanceBounds {
  double lower = 0;                                       ///< attained at `farthest`, rounded down
  double upper = std::numeric_limits<double>::infinity(); ///< proven for every point, rounded outward
  Vec3 farthest;                                          ///< a point of the first surface
};

/// Bounds the largest distance from the triangles of `from` to those of `to`: upper − lower is at most
/// `precision` (> 0, absolute) up to rounding; both are 0 where `from` is empty, infinite where only `to` is.
/// The same bits on any number of threads. A control out of grace ends it with nothing proven.
DistanceBounds bound_distance(const ClosestPointIndex& from, const ClosestPointIndex& to, double precision,
                              const RunControl& control);

} // namespace isoscope
