// The left pane's section of the parameters.
#pragma once

#include "steering/steering.h"
#include "ui/ui.h"

namespace isoscope::panels {

void parameters(Ui& ui, const Steering& steering);

} // namespace isoscope::panels
