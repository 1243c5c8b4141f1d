// One colour, one shape and a few words for every reason: the view, the timeline, lists and help all use
// them.
#pragma once

#include "journal/event.h"
#include "scene/marker_shape.h"
#include "collapse/collapse_attempt.h"

#include <string_view>

namespace isoscope {

/// How a reason is shown; never by colour alone.
struct ReasonStyle {
  std::uint32_t color = 0; ///< 0xRRGGBB, told apart on dark and light grounds
  MarkerShape shape = MarkerShape::disc;
  std::string_view title; ///< "outside Ω"
  std::string_view help;  ///< one sentence
};
/// Reason::none is what was taken. Reasons that reject nothing share a quiet style.
const ReasonStyle& reason_style(Reason reason);

/// How the fate of a cell of the octree search is shown.
struct FateStyle {
  std::uint32_t color = 0;
  std::string_view title, help;
};
const FateStyle& fate_style(OctreeCell::Fate fate);
constexpr std::size_t fate_count = 5;

/// Of Ψ, faces and hatching.
constexpr std::uint32_t invalid_color = 0xD9542B;

} // namespace isoscope
