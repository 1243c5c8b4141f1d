// Commands on the play head, and on holding the run.
#pragma once

#include "command/commands.h"
#include "model/window_state.h"

namespace isoscope {

/// From step to step.
void add_transport_commands(CommandTable& table, WindowState& window);
/// To a step, and how fast.
void add_pace_commands(CommandTable& table, WindowState& window);

} // namespace isoscope
