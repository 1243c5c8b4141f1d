// What scripts can expect of the run, the state and the selection.
#pragma once

#include "command/named_values.h"
#include "model/window_state.h"

namespace isoscope {

void add_run_values(NamedValues& values, const WindowState& window);

} // namespace isoscope
