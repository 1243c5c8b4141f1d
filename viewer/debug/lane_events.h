// The lanes of the timeline as filters of the events, and the event of a lane that is nearest to a step.
#pragma once

#include "debug/debugger.h"

#include <optional>
#include <string_view>

namespace isoscope {

/// What lets a lane's events pass, and no others. Lanes are called as conditions, kinds and reasons are in
/// scripts, and those of saved filters filter-1, filter-2 ..., those of
/// loops of the open rim loop-1, loop-2 ... and loops-other.
struct LaneFilter {
  EventFilter chosen;
  std::string condition; ///< of a saved filter
};
std::optional<LaneFilter> lane_filter(const Debugger& debugger, std::string_view lane);
/// Whether the event list shows just this lane.
bool shows_lane(const Debugger& debugger, std::string_view lane);
/// The lane that it shows, empty where it shows something else.
std::string shown_lane(const Debugger& debugger);

/// Of the lane's events the one whose step is nearest, the earlier of two; nothing where there is none within
/// `reach` steps.
std::optional<std::uint32_t> nearest_event(const Debugger& debugger, std::string_view lane, Step step,
                                           Step reach);

} // namespace isoscope
