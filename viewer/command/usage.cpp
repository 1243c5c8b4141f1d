// The hint of how a command is used comes from the table of commands.
#include "command/usage.h"

#include "command/commands.h"

namespace isoscope {

Error usage(const std::string& what) {
  return {ErrorCode::usage, what, ""};
}

Error usage(const std::string& command, const std::string& what) {
  const Command* known = find_command(command);
  const std::string form = known ? command + " " + std::string(known->usage) : command;
  return {ErrorCode::usage, what, "It is used so: " + form};
}

} // namespace isoscope
