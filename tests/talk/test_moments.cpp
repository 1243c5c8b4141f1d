// Which steps a talk dwells at, and how playing does.
#include "model/transport.h"
#include "talk/meaning.h"
#include "talk/moments.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace isoscope;

namespace {

Event event_of(EventKind kind, Condition condition = Condition::none, Reason reason = Reason::none) {
  Event e;
  e.kind = kind;
  e.condition = condition;
  e.reason = reason;
  return e;
}

void add(Journal& journal, Event e) {
  e.operation = e.kind == EventKind::insertion || e.kind == EventKind::collapse;
  if (e.operation)
    journal.add_operation(e, Delta(), StepFigures());
  else
    journal.add_event(e);
}

void add(Journal& journal, EventKind kind, double value = 0, std::uint32_t count = 1) {
  Event e = event_of(kind);
  e.value = value;
  e.count = count;
  add(journal, e);
}

void add_many(Journal& journal, EventKind kind, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) add(journal, kind);
}

std::vector<Step> steps_of(const Moments& moments) {
  return {moments.steps().begin(), moments.steps().end()};
}

} // namespace

TEST_CASE("moments are the first insertions, changes of the topology, ends of stages, collapses that come at "
          "last") {
  const auto journal = std::make_shared<Journal>();
  Moments moments;
  moments.reset(journal);
  add(*journal, EventKind::stage_begin);
  add_many(*journal, EventKind::insertion, 15); // the first ten
  add(*journal, EventKind::topology_check, 4, 2);
  add_many(*journal, EventKind::insertion, 5);
  add(*journal, EventKind::topology_check, 4, 2); // as before
  add_many(*journal, EventKind::insertion, 5);
  add(*journal, EventKind::topology_check, 2, 1); // at step 25
  moments.update();
  std::vector<Step> expected{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 25};
  CHECK(steps_of(moments) == expected);
  add(*journal, EventKind::insertion);
  add(*journal, EventKind::stage_end);                         // at step 26
  add(*journal, EventKind::collapse);                          // the first of its kind
  add_many(*journal, EventKind::rejection, Moments::patience); // their reason is told once
  add(*journal, EventKind::collapse);                          // at last, leads to step 28
  add_many(*journal, EventKind::rejection, Moments::patience);
  add(*journal, EventKind::collapse); // at last again, in the same stage
  add(*journal, EventKind::stopped);
  for (int i = 0; i < 300; ++i) moments.update(1);
  expected.insert(expected.end(), {26, 27, 27, 28, 29});
  CHECK(steps_of(moments) == expected);
  CHECK(moments.at(27).end - moments.at(27).begin == 2);
  CHECK(moments.at(20).begin == moments.at(20).end);
}

TEST_CASE("a condition is a moment when it first asks, before and after it is served; so is each reason") {
  const auto journal = std::make_shared<Journal>();
  Moments moments;
  moments.reset(journal);
  for (std::uint32_t i = 0; i < 12; ++i)
    add(*journal, event_of(EventKind::insertion, Condition::classification));
  for (int i = 0; i < 2; ++i) add(*journal, event_of(EventKind::insertion, Condition::orientation));
  for (int i = 0; i < 2; ++i) {
    add(*journal, event_of(EventKind::rejection, Condition::none, Reason::kernel_empty));
    add(*journal, event_of(EventKind::rejection, Condition::none, Reason::normals));
  }
  moments.update();
  CHECK(steps_of(moments) == std::vector<Step>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 14, 14});
  const TalkMoment before = moments.all()[10], after = moments.all()[11];
  CHECK(before.event == after.event); // the tetrahedron that faces the wrong way, then without it
  CHECK(journal->events()[moments.all().back().event].reason == Reason::normals);
}

TEST_CASE("what is said has its reason and its figure") {
  CHECK(meaning(event_of(EventKind::insertion, Condition::orientation)).find("across") !=
        std::string_view::npos);
  CHECK(figure_of(event_of(EventKind::insertion, Condition::orientation)) == "Figure 4");
  CHECK(figure_of(event_of(EventKind::rejection, Condition::none, Reason::link_condition)) == "Figure 6");
  Event collapse = event_of(EventKind::collapse);
  collapse.stage = Stage::all;
  CHECK(meaning(collapse) == meaning(Stage::all));
  CHECK(figure_of(collapse) == "Figure 13");
  for (const Stage stage : stages_in_order) CHECK(!meaning(stage).empty());
  for (const Reason reason : rejecting_reasons)
    CHECK(!meaning(event_of(EventKind::rejection, Condition::none, reason)).empty());
  for (int c = 1; c < condition_count; ++c)
    CHECK(!meaning(event_of(EventKind::insertion, static_cast<Condition>(c))).empty());
}

TEST_CASE("playing slows down for a moment, dwells there and goes on") {
  constexpr double frame = 1.0 / 60;
  const std::array<Step, 2> moments{100, 101};
  Transport t;
  t.jump(0);
  t.set_speed(64);
  t.dwell_at(moments);
  t.play();
  int at_first = 0, at_second = 0, frames = 0;
  Step before = 0;
  for (; frames < 60 * 60 && t.step() < 400; ++frames) {
    t.update(frame, 400, false);
    at_first += t.step() == 100;
    at_second += t.step() == 101;
    CHECK(!(before < 100 && t.step() > 100)); // never past it
    before = t.step();
  }
  CHECK(t.step() == 400);
  CHECK(at_first >= static_cast<int>(Transport::dwell_seconds / frame));
  CHECK(at_second >= static_cast<int>(Transport::dwell_seconds / frame));
  CHECK(frames * frame > 400 / 64.0 + 2 * Transport::dwell_seconds);
  CHECK(frames * frame < 400 / 64.0 + 2 * Transport::dwell_seconds + 4);

  t.dwell_at({});
  t.jump(0);
  t.play();
  for (frames = 0; frames < 60 * 60 && t.step() < 400; ++frames) t.update(frame, 400, false);
  CHECK(frames * frame < 400 / 64.0 + 0.1);
}

TEST_CASE("several moments of a step are told one after the other, the one at the start too") {
  const std::array<Step, 4> moments{0, 0, 3, 3};
  Transport t;
  t.set_speed(64);
  t.dwell_at(moments);
  t.jump(0);
  t.play();
  std::array<double, 4> seconds{};
  for (int i = 0; i < 60 * 60 && t.step() < 10; ++i) {
    t.update(1.0 / 60, 10, false);
    if (const auto which = t.dwelling()) seconds.at(*which) += 1.0 / 60;
  }
  for (const double s : seconds) CHECK(s == doctest::Approx(Transport::dwell_seconds).epsilon(0.05));
  CHECK(!t.dwelling());
  CHECK(t.step() == 10);
}

TEST_CASE("before a step playing is held back") {
  Transport t;
  t.set_speed(1000);
  t.slow_before(30, 2);
  t.jump(0);
  t.play();
  for (int i = 0; i < 5 * 60; ++i) t.update(1.0 / 60, 2000, false);
  CHECK(t.step() >= 9);
  CHECK(t.step() <= 11);
  for (int i = 0; i < 20 * 60; ++i) t.update(1.0 / 60, 2000, false);
  CHECK(t.step() == 2000);
}

TEST_CASE("a jump ends the dwelling, and following immediately is never held up") {
  const std::array<Step, 1> moments{5};
  Transport t;
  t.dwell_at(moments);
  t.jump(4);
  t.set_speed(64);
  t.play();
  for (int i = 0; i < 60; ++i) t.update(1.0 / 60, 50, false);
  CHECK(t.step() == 5);
  t.jump(6);
  t.play();
  t.update(1.0 / 60, 50, false);
  t.update(1.0 / 60, 50, false);
  CHECK(t.step() >= 8);
  t.set_immediate(true);
  t.restart();
  t.update(1.0 / 60, 50, true);
  CHECK(t.step() == 50);
}
