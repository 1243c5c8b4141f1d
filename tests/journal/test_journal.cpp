// The journal's bookkeeping, its digest, and the recorder's gate.
#include "journal/synthetic.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("Events know how many operations came before them, operations know their event") {
  Journal journal;
  record_insertions(journal, 300, 50, 1);
  CHECK(journal.steps() == 302); // the box, 300 points, the change of samples
  Step operations = 0;
  for (std::size_t i = 0; i < journal.events().size(); ++i) {
    const Event& e = journal.events()[i];
    CHECK(e.step == operations);
    if (!e.operation) continue;
    CHECK(journal.operations()[operations].event == i);
    ++operations;
  }
  CHECK(operations == journal.steps());
  CHECK(journal.texts()[0].empty());
  CHECK(journal.texts()[journal.events().back().text] == "all points are in");
  CHECK(journal.sample_sets().size() == 2);
}

TEST_CASE("Parameters are those of the last change at or before a step") {
  Journal journal;
  CHECK(journal.parameters_at(0) == CriteriaParameters{});
  record_insertions(journal, 100, 50, 2);
  const Step change = journal.parameters()[1].step;
  CHECK(journal.parameters_at(0).alpha == 0.2);
  CHECK(journal.parameters_at(change - 1).alpha == 0.2);
  CHECK(journal.parameters_at(change).alpha == 0.4);
  CHECK(journal.parameters_at(journal.steps()).alpha == 0.4);
}

TEST_CASE("The byte count grows with what is recorded") {
  Journal journal;
  record_insertions(journal, 10, 20, 3);
  const std::size_t before = journal.memory_bytes();
  std::size_t deltas = 0;
  for (std::size_t i = 0; i < journal.operations().size(); ++i) deltas += journal.operations()[i].stored.size;
  CHECK(before >= deltas + journal.events().size() * sizeof(Event));
  journal.add_event({});
  CHECK(journal.memory_bytes() == before + sizeof(Event));
}

TEST_CASE("Equal runs have equal digests, different ones differ, times do not count") {
  const auto digest_of = [](std::size_t insertions, std::uint64_t seed) {
    Journal journal;
    record_insertions(journal, insertions, 40, seed);
    return digest(journal);
  };
  CHECK(digest_of(100, 7) == digest_of(100, 7));
  CHECK(digest_of(100, 7) != digest_of(100, 8));
  CHECK(digest_of(100, 7) != digest_of(101, 7));

  Journal a, b;
  StepFigures late;
  late.seconds = 9;
  a.add_operation({}, {}, {});
  b.add_operation({}, {}, late);
  CHECK(digest(a) == digest(b));
}

TEST_CASE("The digest takes every field of events, deltas and texts into account") {
  std::vector<std::uint64_t> digests;
  const auto with_event = [&](auto&& edit) {
    Journal journal;
    Event e;
    edit(e);
    journal.add_event(e);
    digests.push_back(digest(journal));
  };
  with_event([](Event&) {});
  with_event([](Event& e) { e.kind = EventKind::stopped; });
  with_event([](Event& e) { e.stage = Stage::gamma; });
  with_event([](Event& e) { e.condition = Condition::height; });
  with_event([](Event& e) { e.reason = Reason::budget; });
  with_event([](Event& e) { e.tet = TetId(3); });
  with_event([](Event& e) { e.sample = SampleId(3); });
  with_event([](Event& e) { e.vertex = VertexId(3); });
  with_event([](Event& e) { e.point.x = 3; });
  with_event([](Event& e) { e.witness.z = 3; });
  with_event([](Event& e) { e.value = 3; });
  with_event([](Event& e) { e.value = -0.0; });
  with_event([](Event& e) { e.limit = 3; });
  with_event([](Event& e) { e.count = 3; });
  with_event([](Event& e) { e.text = 3; });
  const auto with_delta = [&](auto&& edit) {
    Journal journal;
    Delta delta;
    edit(delta);
    journal.add_operation({}, std::move(delta), {});
    digests.push_back(digest(journal));
  };
  with_delta([](Delta&) {});
  with_delta([](Delta& d) { d.added_vertices.push_back({}); });
  with_delta([](Delta& d) { d.killed_vertices.emplace_back(3); });
  with_delta([](Delta& d) { d.values.push_back({VertexId(3), 1, -1}); });
  with_delta([](Delta& d) { d.moves.push_back({VertexId(3), {}, {1, 0, 0}}); });
  with_delta([](Delta& d) { d.added.push_back({TetId(3), {}}); });
  with_delta([](Delta& d) { d.sample_set = Delta::SampleSetChange{0, 1}; });
  Journal texts;
  texts.add_event({});
  texts.add_text("note");
  digests.push_back(digest(texts));
  CHECK(std::set(digests.begin(), digests.end()).size() == digests.size());
}

TEST_CASE("The recorder asks the gate after every event and passes its verdict on") {
  Journal journal;
  OpenGate gate;
  Recorder recorder(journal, gate);
  CHECK(recorder.event({}) == Gate::Verdict::go_on);
  gate.answer = Gate::Verdict::stop;
  Event e;
  e.condition = Condition::witness;
  CHECK(recorder.operation(e, {}, {}) == Gate::Verdict::stop);
  CHECK(gate.passed == 2);
  CHECK(gate.last.operation);
  CHECK(gate.last.condition == Condition::witness);
  CHECK(journal.steps() == 1);
  gate.answer = Gate::Verdict::parameters_changed;
  CHECK(recorder.event({}) == Gate::Verdict::parameters_changed);
  CHECK(gate.last.step == 1);
}
