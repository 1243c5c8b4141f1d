// Commands on the view: mode, camera, clip, what is drawn; and undo of it.
#pragma once

#include "command/commands.h"
#include "model/window_state.h"

#include <string>

namespace isoscope {

void add_view_commands(CommandTable& table, WindowState& window);
/// Takes the view that a JSON text describes; fails with usage where it describes none.
Status show_view(WindowState& window, const std::string& json);

} // namespace isoscope
