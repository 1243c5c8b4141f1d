// Branches with parameters of their own: with unchanged ones they go on as the run that they left did, to the
// last bit, from steps of every stage inside T; with others they end with a proven mesh, the same on any
// number of threads.
#include "base/parallel.h"
#include "journal/journal.h"
#include "run/branch.h"
#include "run/complete_run.h"
#include "run/replay_check.h"
#include "run/session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double patience = 120; // seconds; only a hang reaches it

/// Coarse, to the last stage inside T.
RunParameters quick(const char* name, double percent = 8) {
  RunParameters parameters = complete_parameters(name);
  parameters.tolerance = Tolerance{percent};
  parameters.until = Stage::all;
  return parameters;
}

SessionSnapshot whole(const RunParameters& parameters) {
  Session session;
  session.start(parameters);
  REQUIRE(session.wait_until_settled(patience));
  SessionSnapshot end = session.snapshot();
  REQUIRE(end.phase == SessionPhase::finished);
  return end;
}

SessionSnapshot branched(const SessionSnapshot& from, Step step, const RunParameters& parameters) {
  Session session;
  session.start_branch({from.journal, step, {}, {}, {}}, parameters, *from.scene, from.generation);
  REQUIRE(session.wait_until_settled(patience));
  SessionSnapshot end = session.snapshot();
  CAPTURE(step);
  if (end.error) FAIL(end.error->message);
  REQUIRE(end.phase == SessionPhase::finished);
  return end;
}

/// The first, a middle and the last step of each stage in which a run can go on with other parameters.
std::set<Step> steps_to_leave(const Journal& journal, bool all) {
  std::set<Step> steps;
  std::optional<Step> first;
  Stage stage = Stage::setup;
  const auto add = [&](Step end) {
    if (!first) return;
    for (const Step s : {*first + 1, (*first + end) / 2, end})
      if ((all || s == (*first + end) / 2) && can_go_on(journal, s).ok()) steps.insert(s);
  };
  for (Step k = 0; k < journal.steps(); ++k) {
    const Stage now = journal.events()[journal.operations()[k].event].stage;
    if (first && now == stage) continue;
    add(k);
    stage = now;
    first = k;
  }
  add(journal.steps());
  return steps;
}

/// `all`: else from one step a stage.
void check_same_from_everywhere(const RunParameters& parameters, bool all) {
  CAPTURE(parameters.input);
  const SessionSnapshot trunk = whole(parameters);
  const std::set<Step> steps = steps_to_leave(*trunk.journal, all);
  CHECK(steps.size() > 3);
  for (const Step step : steps) {
    CAPTURE(step);
    CAPTURE(words(stage_to_go_on(*trunk.journal, step)).name);
    const SessionSnapshot branch = branched(trunk, step, trunk.parameters);
    CHECK(branch.journal->events().size() == trunk.journal->events().size());
    CHECK(digest(*branch.journal) == digest(*trunk.journal));
    CHECK(branch.result->mesh.points == trunk.result->mesh.points);
    CHECK(branch.result->branch.starts_with("branched at step " + std::to_string(step)));
  }
}

/// The step that the last operation of a stage leads to.
Step end_of(const Journal& journal, Stage stage) {
  Step end = 0;
  for (Step k = 0; k < journal.steps(); ++k)
    if (journal.events()[journal.operations()[k].event].stage == stage) end = k + 1;
  return end;
}

} // namespace

TEST_CASE("A branch with unchanged parameters is the run that it left, from any stage") {
  check_same_from_everywhere(quick("sphere", 12), true);
}

TEST_CASE("So it is from any stage of a torus" * doctest::test_suite("soak")) {
  check_same_from_everywhere(quick("torus"), true);
}

TEST_CASE("So it is in sampled mode, where samples are followed through T" * doctest::test_suite("soak")) {
  RunParameters parameters = quick("sphere", 12);
  parameters.containment = Containment::sampled;
  parameters.sigma = 0.25;
  check_same_from_everywhere(parameters, false);
}

TEST_CASE("So it is where the topology is mended, and on an open surface" * doctest::test_suite("soak")) {
  check_same_from_everywhere(quick("double-torus", 4), false);
  check_same_from_everywhere(quick("hemisphere", 6), false);
}

TEST_CASE("A branch with another α goes on refining from there, the same on one thread and on two") {
  const SessionSnapshot trunk = whole(quick("torus"));
  const Step end = end_of(*trunk.journal, Stage::refinement);
  for (const Step step : {end / 2, end}) {
    RunParameters other = trunk.parameters;
    other.alpha = 0.6;
    other.threads = 1;
    const SessionSnapshot one = branched(trunk, step, other);
    other.threads = 2;
    const SessionSnapshot two = branched(trunk, step, other);
    CHECK(digest(*one.journal) == digest(*two.journal));
    CHECK(one.result->certificate.holds());
    CHECK(digest(*one.journal) != digest(*trunk.journal));
    CHECK(one.parameters.alpha == 0.6);
    // What was there stays, and right behind it the change is told.
    const std::size_t common = common_events({trunk.journal, step, {}, {}, {}});
    const Event& change = one.journal->events()[common];
    CHECK(change.kind == EventKind::parameter_change);
    CHECK(change.step == step);
    CHECK(one.journal->parameters_at(step).alpha == 0.6);
    CHECK(one.journal->parameters_at(step - 1).alpha == trunk.parameters.alpha);
    CHECK(end_of(*one.journal, Stage::refinement) > end);
  }
}

TEST_CASE("A branch takes other samples where σ is changed, and its journal replays") {
  const SessionSnapshot trunk = whole(quick("sphere", 12));
  RunParameters other = trunk.parameters;
  other.sigma = 0.35;
  other.shrink = 0.6;
  const SessionSnapshot branch = branched(trunk, end_of(*trunk.journal, Stage::refinement) / 2, other);
  CHECK(branch.journal->sample_sets().size() == 2);
  CHECK(branch.result->certificate.holds());
  RunControl control;
  const auto verdict = check_replay(branch.parameters, branch.scene->input, *branch.journal, true, control);
  REQUIRE(verdict.ok());
  CAPTURE(verdict->difference);
  CHECK(verdict->same);
  // And a branch of the branch, behind the change, is the branch.
  const SessionSnapshot again =
      branched(branch, end_of(*branch.journal, Stage::refinement), branch.parameters);
  CHECK(digest(*again.journal) == digest(*branch.journal));
}

TEST_CASE("A branch of a branch by hand goes on behind the collapse") {
  const SessionSnapshot trunk = whole(quick("torus"));
  Step at = 0;
  for (Step k = 0; k < trunk.journal->steps() && at == 0; ++k)
    if (trunk.journal->events()[trunk.journal->operations()[k].event].stage == Stage::zero_set) at = k;
  REQUIRE(at > 0);
  const Event made = trunk.journal->events()[trunk.journal->operations()[at].event];
  Session session;
  session.start_branch({trunk.journal, at, made.vertex, made.other, made.point}, trunk.parameters,
                       *trunk.scene, trunk.generation);
  REQUIRE(session.wait_until_settled(patience));
  const SessionSnapshot by_hand = session.snapshot();
  REQUIRE(by_hand.phase == SessionPhase::finished);
  for (const Step step : {at + 1, at + 12, end_of(*by_hand.journal, Stage::all)}) {
    const SessionSnapshot branch = branched(by_hand, step, by_hand.parameters);
    CHECK(digest(*branch.journal) == digest(*by_hand.journal));
  }
}

TEST_CASE("A run that was stopped and went on is left behind that, too") {
  Session session;
  session.start(quick("torus"), nullptr, true);
  REQUIRE(session.wait_until_settled(patience));
  session.step(40);
  REQUIRE(session.wait_until_settled(patience));
  session.stop();
  REQUIRE(session.wait_until_settled(patience));
  RunParameters other = session.snapshot().parameters;
  other.alpha = 0.3;
  REQUIRE(session.apply(other).ok());
  REQUIRE(session.wait_until_settled(patience));
  const SessionSnapshot trunk = session.snapshot();
  REQUIRE(trunk.phase == SessionPhase::finished);
  const SessionSnapshot branch = branched(trunk, 60, trunk.parameters);
  CHECK(digest(*branch.journal) == digest(*trunk.journal));
}

TEST_CASE("Nobody leaves before the first step, nor once the improver has begun") {
  RunParameters parameters = quick("sphere", 12);
  parameters.until = Stage::improve;
  parameters.effort = 0;
  const SessionSnapshot trunk = whole(parameters);
  CHECK(!can_go_on(*trunk.journal, 0).ok());
  CHECK(!can_go_on(*trunk.journal, trunk.journal->steps()).ok());
  CHECK(can_go_on(*trunk.journal, 1).ok());
  const Status late = can_go_on(*trunk.journal, trunk.journal->steps());
  CHECK(late.error().message.find("improver") != std::string::npos);
}
