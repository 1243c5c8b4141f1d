// Commands on the selection and on what a pick may hit.
#pragma once

#include "command/commands.h"
#include "model/window_state.h"

namespace isoscope {

/// Selecting elements by number.
void add_pick_commands(CommandTable& table, WindowState& window);
/// Clearing and framing the selection, and restricting it to a kind.
void add_selection_commands(CommandTable& table, WindowState& window);

} // namespace isoscope
