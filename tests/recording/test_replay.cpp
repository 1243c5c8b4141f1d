// A recorded run gives the same states when it is run again, and a planted difference is found.
#include "input/temporary_folder.h"
#include "recording/recorded.h"
#include "run/replay_check.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A copy of a journal's first events; `edit` may change each, with its delta where it has one.
std::shared_ptr<Journal> copied(const Journal& journal, std::size_t events,
                                const std::function<void(std::size_t, Event&, Delta&)>& edit = {}) {
  auto copy = std::make_shared<Journal>();
  for (std::size_t i = 1; i < journal.texts().size(); ++i) copy->add_text(journal.texts()[i]);
  for (std::size_t i = 1; i < journal.repairs().size(); ++i) copy->add_repair(journal.repairs()[i]);
  for (std::size_t i = 0; i < journal.sample_sets().size(); ++i)
    copy->add_sample_set(journal.sample_sets()[i]);
  copy->add_parameters(journal.parameters()[0].criteria);
  for (std::size_t i = 0; i < events; ++i) {
    Event event = journal.events()[i];
    Delta delta;
    if (event.operation) delta = journal.operations()[event.step].delta();
    if (edit) edit(i, event, delta);
    if (event.operation)
      copy->add_operation(event, delta, journal.operations()[event.step].figures);
    else
      copy->add_event(event);
  }
  return copy;
}

Result<ReplayVerdict> checked(const Journal& journal, bool ended) {
  RunControl control;
  return check_replay(whole_run().parameters, whole_run().scene->input, journal, ended, control);
}

} // namespace

TEST_CASE("A whole recording replays to the same Z") {
  const TemporaryFolder folder;
  const Journal& journal = *whole_run().journal;
  REQUIRE(write_recording(folder / "a.isorun", whole_run().journal, true).ok());
  const ReadBack back = read_back(folder / "a.isorun");
  REQUIRE(!back.error.has_value());
  const auto verdict = checked(*back.journal, true);
  REQUIRE(verdict.ok());
  CAPTURE(verdict->difference);
  CHECK(verdict->same);
  CHECK(verdict->to_the_end);
  CHECK(verdict->events == journal.events().size());
  CHECK(verdict->operations == journal.operations().size());
  CHECK(verdict->states == journal.operations().size() + 1);
}

TEST_CASE("A part of a recording replays as far as it goes") {
  const Journal& journal = *whole_run().journal;
  for (const std::size_t events :
       {std::size_t{0}, std::size_t{1}, std::size_t{30}, journal.events().size() / 2}) {
    const auto part = copied(journal, events);
    const auto verdict = checked(*part, false);
    REQUIRE(verdict.ok());
    CAPTURE(verdict->difference);
    CHECK(verdict->same);
    CHECK(verdict->events == events);
    CHECK(!verdict->to_the_end);
  }
}

TEST_CASE("The first difference is found and named with its step") {
  const Journal& journal = *whole_run().journal;
  const std::size_t at = journal.operations()[40].event;
  const auto other_number = copied(journal, journal.events().size(), [&](std::size_t i, Event& e, Delta&) {
    if (i == at) e.value += 1e-12;
  });
  const auto first = checked(*other_number, true);
  REQUIRE(first.ok());
  CHECK(!first->same);
  CHECK(first->events == at);
  CHECK(first->step == 40);
  CHECK(first->difference.find("Event " + std::to_string(at) + " at step 40") != std::string::npos);

  const auto other_delta = copied(journal, journal.events().size(), [&](std::size_t i, Event&, Delta& d) {
    if (i == at) d.slots_before += 1;
  });
  const auto second = checked(*other_delta, true);
  REQUIRE(second.ok());
  CHECK(!second->same);
  CHECK(second->step == 40);

  const auto longer = copied(journal, journal.events().size());
  longer->add_event(journal.events()[3]);
  const auto third = checked(*longer, true);
  REQUIRE(third.ok());
  CHECK(!third->same);
  CHECK(third->events == journal.events().size());
}

TEST_CASE("Parameters that were changed during the run are changed at the same event") {
  CompleteRun run(complete_parameters("sphere"));
  run.parameters.effort = 0;
  REQUIRE(run.prepare());
  run.gate.decide = [&run](const Journal& journal, const Event& event) {
    if (!event.operation || (journal.steps() != 20 && journal.steps() != 70)) return Gate::Verdict::go_on;
    run.gate.wanted.alpha = journal.steps() == 20 ? 0.3 : 0.25;
    run.gate.wanted.shrink = 0.6;
    return Gate::Verdict::parameters_changed;
  };
  REQUIRE(run.run());
  REQUIRE(run.journal->parameters().size() == 3);
  RunControl control;
  const auto verdict = check_replay(run.parameters, run.scene->input, *run.journal, true, control);
  REQUIRE(verdict.ok());
  CAPTURE(verdict->difference);
  CHECK(verdict->same);
  CHECK(verdict->to_the_end);
}
