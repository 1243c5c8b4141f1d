// Witnesses of a piece of an input.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/closest_point.h"

#include <vector>

namespace isoscope {

/// Points of {d > δ} in a box or within 2 δ of it, found as those of find_witnesses(): one in every
/// component, of what components have there, that can be seen. The piece has all of the input within 3 δ of
/// the box. Fails with cancelled, or unsupported where δ is too small.
Result<std::vector<Vec3>> witnesses_of_piece(const ClosestPointIndex& piece, double delta, const Box3& within,
                                             const RunControl& control);

} // namespace isoscope
