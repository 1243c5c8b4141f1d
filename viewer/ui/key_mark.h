// Shows which pane has the keys, and which of its items.
#pragma once

#include "ui/ui.h"

namespace isoscope {

/// Within a pane that has the keys, after its items: a frame around it and around the item that Enter would
/// press. `moved`: it has just got them, so its first item is shown at once.
void mark_keys(const Ui& ui, bool moved);

} // namespace isoscope
