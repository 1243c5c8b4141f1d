// The table itself.
#include "command/command_groups.h"

#include <algorithm>

namespace isoscope {

std::span<const Command> command_table() {
  static const std::vector<Command> table = [] {
    std::vector<Command> all;
    for (auto group :
         {file_commands(), recording_commands(), run_commands(), debug_commands(), select_commands(),
          edge_commands(), question_commands(), comparison_commands(), view_commands(), slide_commands(),
          picture_commands(), window_commands(), script_commands(), time_commands()})
      all.insert(all.end(), group.begin(), group.end());
    // The menu of files ends with it.
    std::stable_partition(all.begin(), all.end(), [](const Command& c) { return c.name != "quit"; });
    return all;
  }();
  return table;
}

} // namespace isoscope
