// The diagram of δ: what Ω and the space around it consist of, over the tolerance.
#pragma once

#include "ui/ui.h"

namespace isoscope::panels {

/// A drag in the diagram shows Ω at that δ; buttons take it, and go to where the inside opens or closes.
void tolerance_tab(Ui& ui);

} // namespace isoscope::panels
