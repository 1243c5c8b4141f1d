// A list of events that grows is in the same order as one that is sorted at once.
#include "debug/event_order.h"
#include "support/small_run.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

using namespace isoscope;

TEST_CASE("rows that come in later are merged into their order") {
  Session session;
  const SessionSnapshot run = small_run(session);
  REQUIRE(run.journal != nullptr);
  const EventQuery everything;
  for (const EventColumn column : {EventColumn::step, EventColumn::value, EventColumn::limit,
                                   EventColumn::milliseconds, EventColumn::element})
    for (const bool descending : {false, true}) {
      const EventSort sort{column, descending};
      CAPTURE(static_cast<int>(column));
      CAPTURE(descending);
      FilteredEvents listed;
      JournalIndex index;
      index.reset(run.journal);
      EventOrder grown;
      // The list is ahead of the index, then behind it.
      for (std::size_t round = 0; !listed.complete() || !index.complete(); ++round) {
        listed.update(run.journal, everything, round % 2 == 0 ? 40 : 7);
        index.update(round % 3 == 0 ? 60 : 5);
        EventOrder at_once;
        CHECK(grown.of(listed, index, sort) == at_once.of(listed, index, sort));
      }
      CHECK(grown.of(listed, index, sort).size() == run.journal->events().size());
    }
}

TEST_CASE("what has nothing in a column comes last, equals by step") {
  Session session;
  const SessionSnapshot run = small_run(session);
  FilteredEvents listed;
  JournalIndex index;
  index.reset(run.journal);
  while (index.update()) {}
  while (listed.update(run.journal, {})) {}
  EventOrder order;
  const auto& rows = order.of(listed, index, {EventColumn::value, true});
  REQUIRE(rows.size() == run.journal->events().size());
  const auto value = [&](std::uint32_t row) -> std::optional<double> {
    const auto told = event_numbers(*run.journal, index, row).value;
    return told && !std::isnan(*told) ? told : std::nullopt;
  };
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto a = value(rows[i]), b = value(rows[i + 1]);
    if (!a) CHECK(!b);
    if (a && b) CHECK(*a >= *b);
    if (a == b) CHECK(rows[i] < rows[i + 1]);
  }
}
