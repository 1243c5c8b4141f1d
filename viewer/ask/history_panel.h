// The bottom tab with the history of the selected element.
#pragma once

#include "ask/investigation.h"
#include "ui/ui.h"

namespace isoscope::panels {

void history_tab(Ui& ui, const Investigation& asked);

} // namespace isoscope::panels
