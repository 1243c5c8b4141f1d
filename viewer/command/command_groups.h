// The groups that the table of commands is put together from, in the order of menus and help.
#pragma once

#include "command/commands.h"

#include <vector>

namespace isoscope {

std::vector<Command> file_commands();
std::vector<Command> recording_commands();
std::vector<Command> picture_commands();
std::vector<Command> run_commands();
std::vector<Command> debug_commands();
std::vector<Command> select_commands();
std::vector<Command> edge_commands();
std::vector<Command> question_commands();
std::vector<Command> comparison_commands();
std::vector<Command> view_commands();
std::vector<Command> slide_commands();
std::vector<Command> window_commands();
std::vector<Command> script_commands();
std::vector<Command> time_commands();

} // namespace isoscope
