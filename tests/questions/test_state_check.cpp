// A whole run holds at every step looked at; a planted defect is found with its first step.
#include "questions/state_check.h"

#include "journal/synthetic.h"
#include "questions/state_at.h"
#include "questions/topology_report.h"
#include "run/complete_run.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;
using State = InvariantVerdict::State;

namespace {

/// A finished run of a bundled torus.
const CompleteRun& torus_run() {
  static const std::unique_ptr<CompleteRun> run = [] {
    auto made = std::make_unique<CompleteRun>(complete_parameters("torus"));
    made->parameters.tolerance = {6, true};
    made->run();
    return made;
  }();
  return *run;
}

/// Random insertions; operation `at` moves a vertex through its star, later ones leave it there.
std::shared_ptr<Journal> broken_journal(Step at, Step steps) {
  const auto sound = std::make_shared<Journal>();
  record_insertions(*sound, at, 50, 3);
  auto journal = std::make_shared<Journal>();
  journal->add_sample_set(sphere_samples(50, 4));
  journal->add_parameters({});
  Complex complex;
  Step made = 0;
  for (; made < at - 1 && made < sound->steps(); ++made) {
    Event e = sound->events()[sound->operations()[made].event];
    Delta delta = sound->operations()[made].delta();
    delta.sample_set.reset();
    complex.apply(delta);
    journal->add_operation(e, delta, {});
  }
  const VertexId v(complex.vertices.size() - 1);
  Delta defect;
  defect.moves = {{v, complex.position(v), -25 * complex.position(v)}};
  Event e;
  e.kind = EventKind::insertion;
  journal->add_operation(e, defect, {});
  for (++made; made < steps; ++made) journal->add_operation(e, Delta(), {});
  return journal;
}

} // namespace

TEST_CASE("a sound run is valid at every step looked at, and its goals are due in time") {
  const CompleteRun& run = torus_run();
  REQUIRE(run.result);
  const Step end = run.journal->steps();
  for (Step step = 0; step <= end; step += std::max<Step>(1, end / 12)) {
    const StateReport r = check_state(*run.journal, *state_at(run, step), run.scene.get(), run.control);
    CAPTURE(step);
    for (std::size_t i = 0; i < invariant_count; ++i) {
      CAPTURE(name(static_cast<Invariant>(i)));
      CAPTURE(r.verdicts[i].words);
      CHECK(r.verdicts[i].state != State::broken);
    }
  }
  const StateReport last = check_state(*run.journal, *state_at(run, end), run.scene.get(), run.control);
  CHECK(last[Invariant::contained].state == State::holds);
  CHECK(last[Invariant::topology].state == State::holds);
  CHECK(last[Invariant::samples].state == State::absent); // T is gone
  const StateReport early = check_state(*run.journal, *state_at(run, 5), run.scene.get(), run.control);
  CHECK(early[Invariant::tetrahedra].state == State::holds);
  CHECK(early[Invariant::delaunay].state == State::holds);
  CHECK(early[Invariant::samples].state == State::holds);
  CHECK(early[Invariant::classification].state == State::holds);
  CHECK(early[Invariant::contained].state != State::broken);
}

TEST_CASE("samples and classes that are not what is recorded are noticed") {
  const CompleteRun& run = torus_run();
  StateSnapshot s = *state_at(run, 20);
  s.errors[7] += 0.5f;
  CHECK(check_state(*run.journal, s, nullptr, run.control)[Invariant::classification].state == State::broken);
  s = *state_at(run, 20);
  s.sample_tets[7] = s.sample_tets[7] == TetId(0) ? TetId(1) : TetId(0);
  const StateReport r = check_state(*run.journal, s, nullptr, run.control);
  CHECK(r[Invariant::samples].state == State::broken);
  CHECK(r[Invariant::samples].place == s.samples->positions[7]);
}

TEST_CASE("bisection finds the first step at which something broke") {
  for (const Step at : {Step{2}, Step{17}, Step{40}}) {
    const auto journal = broken_journal(at, 60);
    const FirstInvalid found = find_first_invalid(journal, journal->steps(), nullptr, RunControl());
    REQUIRE(found.end == FirstInvalid::End::found);
    for (std::size_t i = 0; i < invariant_count; ++i) {
      CAPTURE(name(static_cast<Invariant>(i)));
      CAPTURE(found.report.verdicts[i].words);
      if (static_cast<Invariant>(i) != Invariant::tetrahedra)
        CHECK(found.report.verdicts[i].state != State::broken);
    }
    CHECK(found.report.step == at);
    CHECK(found.report[Invariant::tetrahedra].state == State::broken);
    CHECK(found.probes <= 8);
    CHECK(find_first_invalid(journal, at - 1, nullptr, RunControl()).end == FirstInvalid::End::all_valid);
  }
  RunControl cancelled;
  cancelled.cancel();
  CHECK(find_first_invalid(broken_journal(9, 20), 20, nullptr, cancelled).end ==
        FirstInvalid::End::cancelled);
}

TEST_CASE("a torus has one component of genus 1 between two boundaries, and a handle loop") {
  const CompleteRun& run = torus_run();
  const auto state = state_at(run, run.journal->steps());
  const TopologyReport r = report_topology(*state, *run.scene, 500, run.control);
  CHECK(r.verdict.as_expected);
  CHECK(r.thickening);
  CHECK(r.wrong_components == 0);
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].counts.genus() == 1);
  CHECK(r.components[0].sides.size() == 2);
  REQUIRE(r.components[0].expected_genus);
  CHECK(*r.components[0].expected_genus == 1);
  REQUIRE(r.components[0].loop);
  // At least once around the tube or the hole, both wider than what δ leaves of them.
  CHECK(r.components[0].loop->length > 2 * run.scene->delta);
  CHECK(r.components[0].loop->vertices.size() >= 3);
}

TEST_CASE("a boundary of more than χ = 2 is several surfaces and has no genus") {
  CHECK(*BoundarySide{0, 1, 2}.genus() == 0);
  CHECK(*BoundarySide{0, 1, -4}.genus() == 3);
  CHECK(BoundarySide{0, 1, 2}.least_parts() == 1);
  CHECK(!BoundarySide{0, -1, 10}.genus());
  CHECK(BoundarySide{0, -1, 10}.least_parts() == 5);
}

TEST_CASE("Every step of the improver between rooms is sound, and its facets know their rooms") {
  CompleteRun run(complete_parameters("two-rooms"));
  REQUIRE(run.run());
  Playback playback(run.journal);
  std::size_t steps = 0;
  for (Step step = 1; step <= run.journal->steps(); ++step) {
    const Event& e = run.journal->events()[run.journal->operations()[step - 1].event];
    if (e.stage != Stage::improve) continue;
    ++steps;
    const auto snapshot = make_snapshot(playback, step, {}, nullptr);
    CHECK(snapshot->zero_set.has_rooms());
    const StateReport report = check_state(*run.journal, *snapshot, run.scene.get(), {});
    CHECK(report.valid());
  }
  CHECK(steps > 10);
  CHECK(extract_zero_set(replayed(*run.journal)).vertices.size() == 12);
}
