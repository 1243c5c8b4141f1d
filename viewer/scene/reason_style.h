// One colour, one shape and a few words for every reason: the view, the timeline, lists and help all use
// them.
#pragma once

#include "collapse/collapse_attempt.h"
#include "journal/vocabulary.h"

#include <string_view>

namespace isoscope {

/// How a reason is shown, never by colour alone. Reason::none is what was taken.
using ReasonStyle = ReasonWords;
constexpr const ReasonStyle& reason_style(Reason reason) {
  return words(reason);
}

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
