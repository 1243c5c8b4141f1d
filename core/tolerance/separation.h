// How near two surfaces that do not meet come to each other.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"

namespace isoscope {

/// The least distance between the triangles of two surfaces, and the triangle of the first that has it.
struct Separation {
  double distance = std::numeric_limits<double>::infinity();
  TriangleId triangle;
};

/// Branch and bound: a triangle of the first surface is compared with those of the second whose boxes are
/// nearer than the best pair so far, which begins with the nearest vertex. Of no use once the control is
/// cancelled.
Separation find_separation(const ClosestPointIndex& first, const ClosestPointIndex& second,
                           const RunControl& control);

} // namespace isoscope
