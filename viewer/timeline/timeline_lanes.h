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

/// The lanes that have room, and those that have none, both from above.
struct LanesInRoom {
  std::vector<TimelineLane> shown, left_out;
};

/// Of all lanes that hold something so many as `rows` have room for: insertions by condition, operations on
/// edges by kind, rejections by reason, and at the end loops of the open rim by what works on them. Left out
/// are those with the smallest numbers, of loops the shortest, which keep a third; saved filters come first
/// and stay. Where any is left out, one of the rows stays free for a sign that says so. Totals are those of
/// the chosen range of steps, if any.
LanesInRoom timeline_lanes(const Debugger& debugger, ThemeKind theme, std::size_t rows);

/// "+2 lanes, +5 holes": what is left out, in a few letters.
std::string left_out_words(const std::vector<TimelineLane>& left_out);

} // namespace isoscope
