// The lanes of the timeline: what happened how often over the steps.
#pragma once

#include "app/journal_index.h"
#include "app/theme.h"
#include "scene/marker_shape.h"

#include <functional>
#include <string_view>
#include <vector>

namespace isoscope {

/// One lane. Operations are drawn by their share of the steps, rejections, of which there may be any number
/// at a step, by the logarithm of their number.
struct TimelineLane {
  std::string_view title, help;
  Rgb color = 0;
  MarkerShape shape = MarkerShape::disc;
  bool rejections = false;
  std::uint32_t total = 0;
  std::function<std::uint32_t(Step, Step)> count; ///< within [begin, end)
};

/// All lanes that hold something: insertions by condition, operations on edges by kind, rejections by reason.
/// Of more than `most` those with the smallest numbers are left out.
std::vector<TimelineLane> timeline_lanes(const JournalIndex& index, ThemeKind theme, std::size_t most);

} // namespace isoscope
