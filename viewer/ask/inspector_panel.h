// The inspector: everything about the picked element.
#pragma once

#include "ask/investigation.h"
#include "debug/debugger.h"
#include "ui/ui.h"

namespace isoscope::panels {

void inspector(Ui& ui, EdgeProbe& probe, const Debugger& debugger, Investigation& asked);

} // namespace isoscope::panels
