// Commands that share a menu, or when they are possible.
#pragma once

#include "command/commands.h"

#include <initializer_list>

namespace isoscope {

/// Adds them; what one leaves out of menu and `enabled` it takes from `common`.
inline void add_group(CommandTable& table, const Command& common, std::initializer_list<Command> commands) {
  for (Command command : commands) {
    if (command.menu.empty()) command.menu = common.menu;
    if (!command.enabled) command.enabled = common.enabled;
    table.add({std::move(command)});
  }
}

} // namespace isoscope
