// Line segments: edges of borders and rims.
#pragma once

#include "base/geometry.h"

#include <algorithm>
#include <array>

namespace isoscope {

/// A straight piece between two points; both may be the same.
using Segment3 = std::array<Vec3, 2>;

inline Vec3 point_on(const Segment3& s, double t) {
  return s[0] + t * (s[1] - s[0]);
}
/// The parameter in [0, 1] of the point of a segment that is closest to p.
inline double closest_on_segment(Vec3 p, const Segment3& s) {
  const Vec3 along = s[1] - s[0];
  const double l2 = squared_length(along);
  return l2 > 0 ? std::clamp(dot(p - s[0], along) / l2, 0., 1.) : 0;
}
inline double distance_to(const Segment3& s, Vec3 p) {
  return distance(p, point_on(s, closest_on_segment(p, s)));
}

} // namespace isoscope
