// The index of a journal counts what the journal holds, however it is taken in.
#include "model/journal_index.h"
#include "support/small_run.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("counts, figures and changes agree with the journal") {
  Session session;
  const SessionSnapshot run = small_run(session);
  JournalIndex index;
  index.reset(run.journal);
  CHECK(!index.complete());
  while (index.update(3)) {}
  CHECK(index.complete());
  const Step steps = run.journal->steps();
  REQUIRE(index.steps() == steps);

  std::array<std::uint32_t, condition_count> counts{};
  for (Step k = 0; k < steps; ++k) {
    const Event& event = run.journal->events()[run.journal->operations()[k].event];
    ++counts[static_cast<std::size_t>(event.condition)];
    CHECK(index.condition(k) == event.condition);
    CHECK(index.values(Figure::zero_set_vertices)[k] ==
          static_cast<float>(run.journal->operations()[k].figures.zero_set_vertices));
  }
  CHECK(index.counts(0, steps) == counts);
  CHECK(index.counts(0, steps + 100) == counts);
  CHECK(index.counts(7, 3) == std::array<std::uint32_t, condition_count>{});
  REQUIRE(!index.stages().empty());
  CHECK(!index.stages().front().open);

  // A vertex is born by the first operation that names it.
  for (std::uint32_t v = 0; v < 40; ++v) {
    std::optional<Step> born;
    for (Step k = 0; k < steps && !born; ++k)
      if (run.journal->events()[run.journal->operations()[k].event].vertex == VertexId(v)) born = k;
    CHECK(index.birth_of(VertexId(v)) == born);
  }

  if (const auto change = index.next_change(1)) {
    CHECK(index.condition(*change - 1) != index.condition(0));
    for (Step k = 1; k + 1 < *change; ++k) CHECK(index.condition(k) == index.condition(0));
  }
  CHECK(!index.next_change(steps).has_value());
  CHECK(index.first_event_at(0) == 0);
  CHECK(index.first_event_at(steps + 1) == index.events());
}

TEST_CASE("an index without a journal is empty") {
  JournalIndex index;
  CHECK(!index.update());
  CHECK(index.complete());
  CHECK(index.steps() == 0);
  CHECK(index.counts(0, 10) == std::array<std::uint32_t, condition_count>{});
}
