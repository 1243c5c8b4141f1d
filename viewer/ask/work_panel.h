// The bottom tab that tells where the work goes.
#pragma once

#include "ask/investigation.h"
#include "ui/ui.h"

namespace isoscope::panels {

void work_tab(Ui& ui, Investigation& asked);

} // namespace isoscope::panels
