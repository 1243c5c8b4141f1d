// Looking through a journal.
#include "query/search.h"

#include <algorithm>

namespace isoscope {

std::optional<QueryMatch> find(const std::shared_ptr<const Journal>& journal, const QuerySearch& search,
                               const RunControl& control) {
  const auto end = static_cast<std::int64_t>(complete_events(*journal));
  QueryNeeds needs;
  for (const auto& e : search.expressions) needs.add(e->needs());
  const bool follows = needs.any();
  JournalWatch watch(journal, needs, search.expected);
  constexpr std::int64_t patience = 256; ///< events between two looks at the control
  const auto match_at = [&](std::int64_t at) -> std::optional<QueryMatch> {
    const auto event = static_cast<std::uint32_t>(at);
    if (follows) watch.go_to(event);
    for (std::size_t i = 0; i < search.expressions.size(); ++i)
      if (holds(*search.expressions[i], *journal, event, &watch)) return QueryMatch{event, i};
    return std::nullopt;
  };
  if (search.direction == Direction::backward && !follows) {
    for (std::int64_t at = std::min(search.from, end) - 1; at >= 0; --at) {
      if (at % patience == 0 && control.cancelled()) return std::nullopt;
      if (const auto match = match_at(at)) return match;
    }
    return std::nullopt;
  }
  const bool forward = search.direction == Direction::forward;
  const std::int64_t last = forward ? end : std::min(search.from, end);
  std::optional<QueryMatch> found;
  for (std::int64_t at = forward ? search.from + 1 : 0; at < last; ++at) {
    if (at % patience == 0 && control.cancelled()) return std::nullopt;
    const auto match = match_at(at);
    if (match && forward) return match;
    if (match) found = match;
  }
  return found;
}

std::vector<std::uint32_t> matches(const Expression& expression, const Journal& journal, std::uint32_t begin,
                                   std::uint32_t end, JournalWatch* watch) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = begin; i < end; ++i) {
    if (watch != nullptr && watch->needs().any()) watch->go_to(i);
    if (holds(expression, journal, i, watch)) found.push_back(i);
  }
  return found;
}

} // namespace isoscope
