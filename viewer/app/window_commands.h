// Commands on panes, tabs and the look of the window, and on what lies over it.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"

namespace isoscope {

/// Both must outlive the table.
void add_window_commands(CommandTable& table, WindowState& window, const NamedValues& values);

} // namespace isoscope
