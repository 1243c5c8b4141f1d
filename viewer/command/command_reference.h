// The table of commands as a page of the manual.
#pragma once

#include "command/commands.h"

#include <string>

namespace isoscope {

/// All commands by menu, with names, arguments, keys and what they do, as Markdown.
std::string command_reference(const CommandTable& table);

} // namespace isoscope
