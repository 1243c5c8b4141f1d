// For who comes first: three ways in, and marks at what is not obvious.
#pragma once

#include "ui/thumbnails.h"
#include "ui/ui.h"

#include <array>
#include <cstdint>
#include <span>

namespace isoscope::panels {

/// Watch it work, why did it fail, your own model: a picture and a sentence each. `lessons`: the pictures of
/// bundled_lessons(), 0 where there is none.
void welcome(Ui& ui, const Thumbnails& thumbnails, std::span<const std::uint32_t> lessons);

/// A part of the window that a mark points at.
struct CoachPlace {
  ImVec2 low, size;
};
constexpr std::size_t coach_mark_count = 3;
constexpr std::uint8_t all_coach_marks = (1u << coach_mark_count) - 1;
/// Marks at the view, the timeline and the inspector, in this order, but for those that were closed
/// (Settings::coach_closed). A part without size has none.
void coach_marks(Ui& ui, const std::array<CoachPlace, coach_mark_count>& places);

} // namespace isoscope::panels
