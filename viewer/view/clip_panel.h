// The left pane's sections of the clip and of the tetrahedra that are drawn.
#pragma once

#include "ui/ui.h"

namespace isoscope::panels {

void clip_and_filter(Ui& ui);

} // namespace isoscope::panels
