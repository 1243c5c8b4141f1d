// The warnings of the run in sight: a chip over the view that unfolds to all of them in full.
#pragma once

#include "ui/ui.h"

namespace isoscope::overlay {

/// Below the sentence of the operation, in the view's top left corner; the height that it takes, in pixels.
float warning_chip(Ui& ui, ImVec2 low, ImVec2 size);

} // namespace isoscope::overlay
