// The lanes of the loops of an open surface: where each is cut, simplified and filled.
#pragma once

#include "timeline/timeline_lanes.h"

#include <vector>

namespace isoscope {

/// The lanes of at most `most` loops, by number, the longest of them; what has none of its own shares one,
/// the last, where there is room for two. Totals are over the steps in [begin, end). Empty where no rim is
/// open.
std::vector<TimelineLane> loop_lanes(const Debugger& debugger, ThemeKind theme, std::size_t most, Step begin,
                                     Step end);

} // namespace isoscope
