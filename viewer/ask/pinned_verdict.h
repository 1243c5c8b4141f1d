// The line at the top of the inspector that stays while the rest scrolls: what is selected, and its verdict.
#pragma once

#include "ask/investigation.h"
#include "edge/probe.h"
#include "ui/ui.h"

#include <string>

namespace isoscope::panels {

/// A selected element and what is said of it in a few words.
struct ElementVerdict {
  std::string title, words;
  Rgb color = 0;
  MarkerShape shape = MarkerShape::disc;
};
ElementVerdict element_verdict(const Ui& ui, const EdgeProbe& probe, const StateSnapshot& state);

/// At the end of the pane, over what has been scrolled under it; a click goes back to the top.
void pinned_verdict(Ui& ui, const ElementVerdict& verdict);

} // namespace isoscope::panels
