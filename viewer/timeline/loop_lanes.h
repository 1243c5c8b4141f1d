// The lanes of the loops of an open surface: where each is cut, simplified and filled.
#pragma once

#include "timeline/timeline_lanes.h"

#include <vector>

namespace isoscope {

/// The lanes of all loops that something worked on, the longest first; what has none of its own shares one,
/// the last. Totals are over the steps in [begin, end). Empty where no rim is open.
std::vector<TimelineLane> loop_lanes(const Debugger& debugger, ThemeKind theme, Step begin, Step end);

} // namespace isoscope
