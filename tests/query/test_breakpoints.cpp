// Breakpoints hold a run at exactly the event they name.
#include "query/breakpoints.h"
#include "query/search.h"
#include "run/complete_run.h"
#include "run/session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double patience = 60;

/// To the last stage with the least effort.
RunParameters quick(const char* model) {
  RunParameters parameters = complete_parameters(model);
  parameters.effort = 0;
  return parameters;
}

/// Every event at which the expression holds, from a run without breakpoints.
std::vector<std::uint32_t> expected_hits(const Journal& journal, const std::string& text) {
  const auto expression = std::get<std::shared_ptr<const Expression>>(parse_query(text));
  JournalWatch watch(journal, expression->needs());
  return matches(*expression, journal, 0, static_cast<std::uint32_t>(journal.events().size()), &watch);
}

unsigned added(BreakpointSet& set, const std::string& text) {
  const auto id = set.add(text);
  REQUIRE(std::holds_alternative<unsigned>(id));
  return std::get<unsigned>(id);
}

Breakpoint asking(BreakpointSet& set) {
  return [&set](const Journal& journal, const Event&) {
    const auto hit = set.ask(journal);
    return hit ? hit->note() : std::string();
  };
}

} // namespace

TEST_CASE("a session stops at every event that matches, and nowhere else") {
  CompleteRun alone(quick("sphere"));
  REQUIRE(alone.run());
  for (const std::string text : {"reject && reason == kernel_empty || repair", "stage_begin",
                                 "sample(5).class changes", "collapse && stage == zero_set && value > 0"}) {
    CAPTURE(text);
    std::vector<std::uint32_t> expected = expected_hits(*alone.journal, text);
    REQUIRE(!expected.empty());
    if (expected.size() > 6) expected.resize(6);
    BreakpointSet set;
    const unsigned id = added(set, text);
    Session session;
    session.set_breakpoint(asking(set));
    session.start(quick("sphere"));
    for (const std::uint32_t event : expected) {
      REQUIRE(session.wait_until_settled(patience));
      const SessionSnapshot s = session.snapshot();
      REQUIRE(s.phase == SessionPhase::paused);
      CHECK(s.journal->events().size() == event + 1);
      REQUIRE(set.last_hit());
      CHECK(set.last_hit()->event == event);
      CHECK(set.last_hit()->id == id);
      CHECK(s.pause_note == set.last_hit()->note());
      session.resume();
    }
    session.set_breakpoint({});
    session.resume();
    REQUIRE(session.wait_until_settled(patience));
    CHECK(session.snapshot().phase == SessionPhase::finished);
    CHECK(digest(*session.snapshot().journal) == digest(*alone.journal));
    CHECK(set.list().front().hits >= expected.size());
  }
}

TEST_CASE("counts, ignored hits, switching and removing") {
  BreakpointSet set;
  const unsigned collapse = added(set, "insertion"), step = added(set, "step == 3");
  const unsigned off = added(set, "all");
  CHECK(set.enable(off, false));
  CHECK(set.ignore(collapse, 2));
  CHECK(!set.enable(99, true));
  CHECK(!set.remove(99));
  CHECK(std::holds_alternative<QueryError>(set.add("rejct")));
  CHECK(std::holds_alternative<QueryError>(set.add("  ")));
  CHECK(set.list().size() == 3);
  CHECK(set.enabled().size() == 2);

  Journal journal;
  std::vector<unsigned> spoken;
  Event e;
  e.kind = EventKind::insertion;
  for (int i = 0; i < 5; ++i) {
    journal.add_operation(e, {}, {});
    const auto hit = set.ask(journal);
    spoken.push_back(hit ? hit->id : 0);
  }
  CHECK(spoken == std::vector<unsigned>{0, 0, collapse, collapse, collapse});
  auto list = set.list();
  CHECK(list[0].hits == 5);
  CHECK(list[1].hits == 1); // counted although the first one spoke
  CHECK(list[1].last_event == 3u);
  CHECK(list[2].hits == 0);
  CHECK(set.last_hit()->note() == "breakpoint 1 (insertion) at event 4, step 4");

  CHECK(set.remove(collapse));
  CHECK(set.remove(step));
  CHECK(!set.any_enabled());
  CHECK(added(set, "all") == 4);
  set.forget_hits();
  CHECK(!set.last_hit());
}

TEST_CASE("counts are of one run: another journal begins at 0") {
  BreakpointSet set;
  added(set, "insertion");
  Event e;
  e.kind = EventKind::insertion;
  Journal first, second;
  for (int i = 0; i < 3; ++i) {
    first.add_operation(e, {}, {});
    CHECK(set.ask(first));
  }
  CHECK(set.list().front().hits == 3);
  added(set, "step == 0 && components == 0"); // asks for more: the same run all the same
  first.add_operation(e, {}, {});
  CHECK(set.ask(first));
  CHECK(set.list().front().hits == 4);
  second.add_operation(e, {}, {});
  REQUIRE(set.ask(second));
  CHECK(set.list().front().hits == 1);
  CHECK(set.list().front().last_event == 0u);
  CHECK(set.last_hit()->event == 0u);
  set.forget_hits();
  CHECK(set.list().front().hits == 0);
  CHECK(!set.last_hit());
}

TEST_CASE("one that asks for more while a run is under way knows what went before") {
  const auto run = std::make_unique<CompleteRun>(gallery_parameters("torus"));
  REQUIRE(run->run());
  // An inner sample: bad until the first inner vertices are there.
  const auto& labels = run->scene->samples->labels;
  const auto inner = std::find(labels.begin(), labels.end(), std::int8_t{-1}) - labels.begin();
  const std::string changing = "sample(" + std::to_string(inner) + ").class changes";
  const std::vector<std::uint32_t> changes = expected_hits(*run->journal, changing);
  REQUIRE(changes.size() >= 2);
  // The journal is made again event by event; the breakpoint comes in the middle.
  Journal again;
  for (std::size_t i = 0; i < run->journal->sample_sets().size(); ++i)
    again.add_sample_set(run->journal->sample_sets()[i]);
  again.add_parameters(run->journal->parameters_at(0));
  BreakpointSet set;
  added(set, "vertices > 1000000");
  std::vector<std::uint32_t> hits;
  for (std::uint32_t i = 0; i < run->journal->events().size(); ++i) {
    const Event& e = run->journal->events()[i];
    if (e.operation) {
      const Operation& o = run->journal->operations()[e.step];
      again.add_operation(e, o.delta(), o.figures);
    } else {
      again.add_event(e);
    }
    if (i == changes[0]) added(set, changing);
    if (set.ask(again)) hits.push_back(i);
  }
  CHECK(hits == changes);
}

TEST_CASE("what a breakpoint costs an event") {
  CompleteRun run(quick("torus"));
  REQUIRE(run.run());
  const Journal& journal = *run.journal;
  for (const std::string text :
       {"reject && reason == kernel_empty && value > 1e30", "stall(100000)", "edge near (9,9,9) 0.1",
        "sample(5).class == outside && step > 1e9", "genus > 1000"}) {
    const auto expression = std::get<std::shared_ptr<const Expression>>(parse_query(text));
    const auto begin = std::chrono::steady_clock::now();
    JournalWatch watch(journal, expression->needs());
    const auto found =
        matches(*expression, journal, 0, static_cast<std::uint32_t>(journal.events().size()), &watch);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    CHECK(found.empty());
    MESSAGE(text << ": " << took.count() / static_cast<double>(journal.events().size()) << " µs an event, "
                 << journal.events().size() << " events, " << journal.steps() << " operations");
  }
}
