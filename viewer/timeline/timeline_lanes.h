// The lanes of the timeline: what happened how often over the steps.
#pragma once

#include "debug/debugger.h"
#include "journal/vocabulary.h"
#include "ui/theme.h"

#include <functional>
#include <string_view>
#include <vector>

namespace isoscope {

/// A part of the bars of a lane.
struct LanePart {
  Rgb color = 0;
  std::function<std::uint32_t(Step, Step)> count; ///< within [begin, end)
};

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
  std::vector<LanePart> parts; ///< from below
  std::string letter;          ///< of a saved filter, instead of the shape
};

/// All lanes that hold something: insertions by condition, operations on edges by kind, rejections by reason,
/// and at the end loops of the open rim by what works on them. Of more than `most` those with the smallest
/// numbers are left out, of loops the shortest, which keep a third. Saved filters come first and stay. Totals
/// are those of the chosen range of steps, if any.
std::vector<TimelineLane> timeline_lanes(const Debugger& debugger, ThemeKind theme, std::size_t most);

} // namespace isoscope
