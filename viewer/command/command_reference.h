// The table of commands as a page of the manual.
#pragma once

#include <string>

namespace isoscope {

/// All commands by menu, with names, arguments, keys and what they do, as Markdown.
std::string command_reference();

} // namespace isoscope
