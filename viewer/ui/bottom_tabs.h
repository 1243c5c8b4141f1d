// The tabs of the bottom pane by name, in the order of their enumeration.
#pragma once

#include "model/settings.h"
#include "ui/icons.h"

#include <algorithm>
#include <array>

namespace isoscope {

struct BottomTabName {
  const char* word;  ///< what scripts type
  const char* title; ///< what the pane shows
  const char* glyph;
};
constexpr std::array<BottomTabName, bottom_tab_count> bottom_tabs{{{"timeline", "Timeline", icon::clock},
                                                                   {"plots", "Plots", icon::chart},
                                                                   {"events", "Events", icon::list},
                                                                   {"breakpoints", "Breakpoints", icon::dot},
                                                                   {"history", "History", icon::history},
                                                                   {"work", "Work", icon::bolt},
                                                                   {"compare", "Compare", icon::split},
                                                                   {"tolerance", "Tolerance", icon::sliders},
                                                                   {"loops", "Holes", icon::hole}}};
static_assert(std::all_of(bottom_tabs.begin(), bottom_tabs.end(),
                          [](const BottomTabName& tab) { return tab.word != nullptr; }));

} // namespace isoscope
