// Several insides: regions that keep a label of their own (§4.2).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/region_labels.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <optional>

namespace isoscope {

/// Labels from the unbounded region inwards. Where two deep regions meet a component of Ω' they alternate, as
/// insides and cavities do; where more do, each has a number that no other one there has: -1, -2, … Numbers
/// are used again where regions cannot meet. Shallow regions, pockets in Ω, go with a deep one beside them.
/// Fails with unsupported where there are more rooms than numbers, and at a fin: an open sheet on a wall. Of
/// no use once the control is cancelled.
Result<DepthLabels> label_rooms(const ToleranceVolume& volume, const RunControl& control);

/// A place on a wall of a component of Ω' with one region on both its sides, the first by triangle; of all
/// components where none is named.
std::optional<Vec3> one_sided_wall(const ToleranceVolume& volume, std::optional<std::uint32_t> component,
                                   const RunControl& control);

} // namespace isoscope
