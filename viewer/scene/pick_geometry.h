// Where a picked element lies at a step.
#pragma once

#include "run/snapshot.h"
#include "scene/view_settings.h"

#include <optional>

namespace isoscope {

/// The ends of a picked edge. One that the current operation collapsed lies where it was before it.
std::optional<std::array<Vec3, 2>> edge_positions(const StateSnapshot& state, const Pick& pick);
/// Everything of the element, empty where the state has it not.
Box3 pick_bounds(const StateSnapshot& state, const Pick& pick);

} // namespace isoscope
