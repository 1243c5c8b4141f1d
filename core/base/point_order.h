// One order of points for all who sort them.
#pragma once

#include "base/geometry.h"

#include <tuple>

namespace isoscope {

/// By x, then y, then z.
inline bool lies_before(Vec3 a, Vec3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

} // namespace isoscope
