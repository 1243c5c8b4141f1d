// The presenter mode's own parts.
#pragma once

#include "talk/talk.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// The sentence of the step shown, and where in the run it is.
void presenter_bar(Ui& ui, const Talk& talk);
/// Number and note of the bookmark that is shown, over the view; `low` is the view's corner.
void slide_title(const Ui& ui, const Bookmarks& bookmarks, ImVec2 low, float width);

} // namespace isoscope::panels
