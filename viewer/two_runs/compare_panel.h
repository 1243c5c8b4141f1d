// The bottom tab that tells what differs between two runs.
#pragma once

#include "two_runs/comparison.h"
#include "ui/ui.h"

namespace isoscope::panels {

void compare_tab(Ui& ui, const Comparison& comparison);

} // namespace isoscope::panels
