// The part of the input that bounds its inside: what a mesh has to be near to.
#pragma once

#include "base/run_control.h"
#include "tolerance/tolerance_volume.h"

#include <memory>
#include <optional>

namespace isoscope {

/// What is left of the input, and where gaps were closed.
struct ExposedInput {
  std::shared_ptr<const ClosestPointIndex> walls;
  /// A point of a wall that was left out because another part stands within 2δ' in front of it; absent where
  /// there is none.
  std::optional<Vec3> closed_gap;
};

/// The input without its inner walls: those that have the inside on both sides, as where closed parts overlap
/// or touch, and those in gaps between parts that Ω closes, 2δ' wide at most. Fins, which end in the open,
/// are no inner walls. The input itself where there can be none. Where a triangle is crossed by others it is
/// cut into pieces of at most `finest` (> 0, absolute), before other parts into pieces of at most δ/2; they
/// are judged by their middles: what is left out there is that near to what is kept. Not all of it when
/// abandoned.
ExposedInput exposed_input(const ToleranceVolume& volume, double finest, const RunControl& control);

} // namespace isoscope
