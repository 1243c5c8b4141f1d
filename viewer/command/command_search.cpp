// Scores of a subsequence, and the order they give.
#include "command/command_search.h"

#include "base/folded.h"

#include <algorithm>
#include <utility>

namespace isoscope {
namespace {

bool word_begins(std::string_view text, std::size_t at) {
  return at == 0 || text[at - 1] == ' ' || text[at - 1] == '-';
}

} // namespace

std::optional<int> fuzzy_score(std::string_view typed, std::string_view text) {
  constexpr int letter = 1, in_a_row = 4, word = 6, largest_gap = 3;
  std::optional<int> best;
  // Every place of the first letter is tried: the first one may spoil a run that comes later.
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    int score = 0;
    std::size_t at = begin, matched = 0, last = begin;
    for (; at < text.size() && matched < typed.size(); ++at) {
      if (typed[matched] == ' ' && (matched > 0)) {
        ++matched;
        if (matched == typed.size()) break;
      }
      if (folded(text[at]) != folded(typed[matched])) {
        if (matched == 0) break;
        continue;
      }
      const int gap = matched > 0 ? static_cast<int>(at - last) - 1 : 0;
      score += letter + (matched > 0 && gap == 0 ? in_a_row : 0) + (word_begins(text, at) ? word : 0) -
               std::min(gap, largest_gap);
      last = at;
      ++matched;
    }
    if (matched == typed.size() && matched > 0)
      best = std::max(best.value_or(-1000), score * 8 - static_cast<int>(std::min<std::size_t>(begin, 7)));
  }
  return best;
}

std::vector<const Command*> search_commands(const CommandTable& table, std::string_view typed) {
  while (!typed.empty() && typed.back() == ' ') typed.remove_suffix(1);
  while (!typed.empty() && typed.front() == ' ') typed.remove_prefix(1);
  const std::string name = table.parse(typed).name;
  std::vector<std::pair<int, const Command*>> scored;
  for (const Command& command : table.all()) {
    if (command.for_scripts) continue;
    std::optional<int> score = typed.empty() ? std::optional(0) : std::nullopt;
    if (!typed.empty()) {
      score = std::max(fuzzy_score(typed, command.title), fuzzy_score(typed, command.name));
      // In sentences any letters are found in order: there the text itself must stand.
      if (!score && contains_folded(command.help, typed)) score = -1000;
      if (command.name == name) score = 100000;
    }
    if (score) scored.emplace_back(*score, &command);
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Command*> found;
  for (const auto& entry : scored) found.push_back(entry.second);
  return found;
}

} // namespace isoscope
