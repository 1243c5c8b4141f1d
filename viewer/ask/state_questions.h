// What the inspector asks of the whole state.
#pragma once

#include "ask/investigation.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// Violations, topology, validity.
void state_questions(Ui& ui, Investigation& asked, const StateSnapshot& state);

} // namespace isoscope::panels
