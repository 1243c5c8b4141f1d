// Points that tell whether Z separates the sides: at least one in every component of the complement of Ω that
// can be seen.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"

#include <vector>

namespace isoscope {

class ToleranceVolume;

/// A point and the side of Z that it must stay on. Outside of Ω, as no Z inside Ω passes through {φ > δ}, one
/// point of each of its components decides for all of it.
struct Witness {
  Vec3 point;
  int label = +1;     ///< F of its side
  double depth = 0;   ///< φ(point), > δ but for those that cover
  bool cover = false; ///< it lies in Ω, where the input is thin, and keeps Z near (run/cover_witnesses.h)
};

/// Witnesses of {d > δ}, whose components are smaller than the regions of {d > δ'}: Z may pass where a region
/// is narrow and cut a part of it off. From the octree's cells, and, for closed input, from both sides of
/// every triangle at distance δ, where components below the octree's resolution show. Those that are plainly
/// joined to another one are left out. The unbounded region comes first. Fewer once the control is cancelled.
std::vector<Witness> find_witnesses(const ToleranceVolume& volume, const RunControl& control);

} // namespace isoscope
