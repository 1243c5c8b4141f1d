// The lanes of the timeline: what happened how often over the steps.
#pragma once

#include "debug/debugger.h"
#include "journal/vocabulary.h"
#include "ui/theme.h"

#include <functional>
#include <string_view>
#include <vector>

namespace isoscope {

/// One lane. Operations are drawn by their share of the steps, rejections, of which there may be any number
/// at a step, by the logarithm of their number.
struct TimelineLane {
  std::string name; ///< in scripts
  std::string title;
  std::string_view help;
  Rgb color = 0;
  MarkerShape shape = MarkerShape::disc;
  bool rejections = false;
  std::uint32_t total = 0;
  std::function<std::uint32_t(Step, Step)> count; ///< within [begin, end)
  std::string letter;                             ///< of a saved filter, instead of the shape
};

/// All lanes that hold something: insertions by condition, operations on edges by kind, rejections by reason.
/// Of more than `most` those with the smallest numbers are left out. Saved filters come first and stay.
/// Totals are those of the chosen range of steps, if any.
std::vector<TimelineLane> timeline_lanes(const Debugger& debugger, ThemeKind theme, std::size_t most);

} // namespace isoscope
