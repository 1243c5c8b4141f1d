// Samples that keep Z near to the outside of parts that overlap (core/README.md, N2).
#pragma once

#include "base/run_control.h"
#include "criteria/nearest_sample.h"
#include "run/input_walls.h"
#include "tolerance/tolerance_volume.h"

#include <vector>

namespace isoscope {

/// Where parts overlap, Z could leave their outside for the walls within their union, which lie in Ω as well:
/// on Z alone nothing but witnesses keeps it from that. Adds samples of both sides to what is held, one of
/// each within `reach` of every place of the outside that is no farther than that from another part, where
/// there is one and nothing held is as near. None where no parts overlap. Fewer once the control is
/// cancelled.
void hold_overlaps(const ToleranceVolume& volume, const NearestSample& samples, const InputWalls& walls,
                   double reach, std::vector<Witness>& held, const RunControl& control);

} // namespace isoscope
