// Breakpoints that the inspector offers on what it shows.
#pragma once

#include "debug/debugger.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// On the selection, the gate or the event shown.
void break_rows(Ui& ui, const Debugger& debugger);

} // namespace isoscope::panels
