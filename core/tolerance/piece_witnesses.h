// Witnesses of a piece of an input.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/closest_point.h"

#include <vector>

namespace isoscope {

/// Points of {d > δ}, found as those of find_witnesses(): one in every component that can be seen. Of
/// components that reach beyond the piece they need not speak. Fails with cancelled, or unsupported where δ
/// is too small.
Result<std::vector<Vec3>> witnesses_of_piece(const ClosestPointIndex& piece, double delta,
                                             const RunControl& control);

} // namespace isoscope
