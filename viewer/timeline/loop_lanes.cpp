// Lanes of loops.
#include "timeline/loop_lanes.h"

namespace isoscope {
namespace {

Rgb color_of(LoopWork work, const Palette& colors) {
  switch (work) {
  case LoopWork::cutting:
    return colors.rim;
  case LoopWork::simplifying:
    return colors.good;
  case LoopWork::filling:
    return colors.zero;
  }
  return colors.quiet;
}

} // namespace

std::vector<TimelineLane> loop_lanes(const Debugger& debugger, ThemeKind theme, Step begin, Step end) {
  const LoopEvents& loops = debugger.loops;
  std::vector<TimelineLane> lanes;
  for (const std::uint32_t loop : loops.lanes()) {
    TimelineLane lane;
    lane.name = loop_lane_name(loop);
    lane.title = loops.title(loop);
    lane.help =
        "What works on this loop of the rim: edge splits and the cut in the colour of the rim, collapses "
        "of its border in green, its filling in the colour of Z. Numbers are those of the list of holes. "
        "§4.1";
    lane.color = palette(theme).rim;
    lane.shape = MarkerShape::ring;
    lane.total = loops.count(loop, begin, end);
    for (int w = 0; w < loop_work_count; ++w) {
      const auto work = static_cast<LoopWork>(w);
      lane.parts.push_back({color_of(work, palette(theme)),
                            [&loops, loop, work](Step a, Step b) { return loops.count(loop, work, a, b); }});
    }
    if (lane.total > 0) lanes.push_back(std::move(lane));
  }
  return lanes;
}

} // namespace isoscope
