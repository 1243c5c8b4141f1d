// The bar on top: menus, the model and δ, stage chips, transport, LIVE.
#pragma once

#include "ui/ui.h"

namespace isoscope::panels {

void top_bar(Ui& ui);

} // namespace isoscope::panels
