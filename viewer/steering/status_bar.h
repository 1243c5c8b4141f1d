// The line at the bottom and the messages over the view.
#pragma once

#include "two_runs/comparison.h"
#include "ui/ui.h"

namespace isoscope::panels {

void status_bar(Ui& ui, const HistoryMemory& memory);
void messages(Ui& ui, ImVec2 low, float width);

} // namespace isoscope::panels
