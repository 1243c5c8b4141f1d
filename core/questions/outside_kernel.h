// Which points an edge could collapse to by the look of it and may not, because they lie outside its kernel.
#pragma once

#include "questions/edge_xray.h"

#include <vector>

namespace isoscope {

struct OutsidePoint {
  enum class What : std::uint8_t { kept_end, removed_end, least_error };
  What what = What::kept_end;
  Vec3 point;
  double outside = 0;           ///< how far from the plane that it misses most, a length
  std::uint32_t half_space = 0; ///< that one, of the kernel
};

/// Of an edge whose kernel is not empty: those of its ends and the place of least error that are not strictly
/// inside. Where no candidate lay in the kernel, these are what was looked at.
std::vector<OutsidePoint> points_outside(const EdgeXray& xray);

} // namespace isoscope
