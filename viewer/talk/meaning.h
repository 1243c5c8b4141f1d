// Why an event matters, for an audience, and which figure of the paper shows the like.
#pragma once

#include "journal/event.h"

#include <string_view>

namespace isoscope {

/// One sentence; empty where the event says all itself.
std::string_view meaning(const Event& event);
/// What a stage is for.
std::string_view meaning(Stage stage);
/// "Figure 7"; empty where the paper has none.
std::string_view figure_of(const Event& event);
std::string_view figure_of(Stage stage);

} // namespace isoscope
