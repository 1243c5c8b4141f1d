// Finding commands by a few letters.
#pragma once

#include "command/commands.h"

#include <optional>
#include <string_view>
#include <vector>

namespace isoscope {

/// How well `typed` names `text`, without regard to case: its letters must occur in order; runs of letters
/// and beginnings of words count more, and an early match more than a late one. Nullopt when it does not.
std::optional<int> fuzzy_score(std::string_view typed, std::string_view text);

/// The commands that people may call and that `typed` names, best first, equals in the table's order; all of
/// them when nothing is typed. What follows a command's full name counts as its arguments.
std::vector<const Command*> search_commands(const CommandTable& table, std::string_view typed);

} // namespace isoscope
