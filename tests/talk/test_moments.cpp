// Which steps a talk dwells at, and how playing does.
#include "model/transport.h"
#include "talk/moments.h"

#include <doctest/doctest.h>

#include <array>

using namespace isoscope;

namespace {

void add(Journal& journal, EventKind kind, double value = 0, std::uint32_t count = 1) {
  Event e;
  e.kind = kind;
  e.value = value;
  e.count = count;
  e.operation = kind == EventKind::insertion || kind == EventKind::collapse;
  if (e.operation)
    journal.add_operation(e, Delta(), StepFigures());
  else
    journal.add_event(e);
}

void add_many(Journal& journal, EventKind kind, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) add(journal, kind);
}

} // namespace

TEST_CASE("moments are where stages begin, topology changes and a collapse comes through at last") {
  const auto journal = std::make_shared<Journal>();
  Moments moments;
  moments.reset(journal);
  add(*journal, EventKind::stage_begin);
  add_many(*journal, EventKind::insertion, 10);
  add(*journal, EventKind::topology_check, 4, 2);
  add_many(*journal, EventKind::insertion, 5);
  add(*journal, EventKind::topology_check, 4, 2); // as before
  add_many(*journal, EventKind::insertion, 5);
  add(*journal, EventKind::topology_check, 2, 1); // at step 20
  moments.update();
  CHECK(moments.steps() == std::vector<Step>{0, 20});
  add(*journal, EventKind::insertion);
  add(*journal, EventKind::stage_begin); // at step 21
  add_many(*journal, EventKind::rejection, Moments::patience - 1);
  add(*journal, EventKind::collapse);
  add_many(*journal, EventKind::rejection, Moments::patience);
  add(*journal, EventKind::collapse); // leads to step 23
  add(*journal, EventKind::stopped);
  for (int i = 0; i < 300; ++i) moments.update(1);
  CHECK(moments.steps() == std::vector<Step>{0, 20, 21, 23});
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
