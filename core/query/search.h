// The next or the previous event of a journal at which one of several expressions holds.
#pragma once

#include "base/run_control.h"
#include "query/watch.h"

#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

enum class Direction : std::int8_t { backward = -1, forward = 1 };

struct QuerySearch {
  std::vector<std::shared_ptr<const Expression>> expressions;
  std::int64_t from = -1; ///< the event to leave; -1: before the first one
  Direction direction = Direction::forward;
  ExpectedGenus expected;
};

struct QueryMatch {
  std::uint32_t event = 0;
  std::size_t expression = 0; ///< index of the first that holds there
};

/// Among the events that are complete now. Expressions without needs are judged from `from` on; others follow
/// the journal from its beginning, also backward. Absent where there is none, or when cancelled.
std::optional<QueryMatch> find(const std::shared_ptr<const Journal>& journal, const QuerySearch& search,
                               const RunControl& control);

/// All events at which the expression holds, from `begin` on up to `end`; `watch` may be null where the
/// expression has no needs.
std::vector<std::uint32_t> matches(const Expression& expression, const Journal& journal, std::uint32_t begin,
                                   std::uint32_t end, JournalWatch* watch);

} // namespace isoscope
