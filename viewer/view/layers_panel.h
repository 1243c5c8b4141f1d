// The left pane's section of layers.
#pragma once

#include "ui/ui.h"

namespace isoscope::panels {

void layers(Ui& ui);

} // namespace isoscope::panels
