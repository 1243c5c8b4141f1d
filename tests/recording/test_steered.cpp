// Recordings of runs that somebody steered: other σ, α and shrink on the way, branches, branches of branches.
#include "input/temporary_folder.h"
#include "recording/recorded.h"
#include "run/parameters_json.h"
#include "run/replay_check.h"
#include "run/session.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// To the last stage with the least effort.
RunParameters quick(const char* name) {
  RunParameters parameters = complete_parameters(name);
  parameters.effort = 0;
  return parameters;
}

/// Reads the file and runs it again with what it says of itself.
ReplayVerdict replayed_from(const std::filesystem::path& file) {
  const ReadBack back = read_back(file);
  REQUIRE(!back.error.has_value());
  REQUIRE(back.end.has_value());
  const auto parameters = parse_parameters(back.reader->header().parameters);
  REQUIRE(parameters.ok());
  RunControl control;
  const auto verdict =
      check_replay(*parameters, back.reader->header().input, *back.journal, back.end.has_value(), control);
  REQUIRE(verdict.ok());
  CAPTURE(verdict->difference);
  CHECK(verdict->same);
  CHECK(verdict->to_the_end);
  CHECK(verdict->events == back.journal->events().size());
  return *verdict;
}

/// The first collapse of a stage from `step` on.
const Event& collapse_of(const Journal& journal, Stage stage, Step step) {
  for (std::size_t i = 0; i < journal.events().size(); ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::collapse && e.stage == stage && e.step >= step && e.reason != Reason::user)
      return e;
  }
  FAIL("no such collapse");
  return journal.events()[0];
}

/// Leaves the run before one of its collapses and makes that collapse by hand; records the branch to its end.
Session recorded_branch(const SessionSnapshot& trunk, const Event& at, const std::filesystem::path& file) {
  Session branch;
  branch.start_branch({trunk.journal, at.step, at.vertex, at.other, at.point}, trunk.parameters, *trunk.scene,
                      trunk.generation);
  REQUIRE(branch.record(file).ok());
  REQUIRE(branch.wait_until_settled(120));
  const SessionSnapshot made = branch.snapshot();
  REQUIRE(made.phase == SessionPhase::finished);
  REQUIRE(made.journal->steps() > at.step);
  return branch;
}

} // namespace

TEST_CASE("A run whose σ, α and shrink were changed on the way is recorded and replays") {
  const TemporaryFolder folder;
  Digest live;
  {
    Session session;
    session.start(quick("sphere"), nullptr, true);
    REQUIRE(session.wait_until_settled(60));
    REQUIRE(session.record(folder / "run.isorun").ok());
    session.step(30);
    REQUIRE(session.wait_until_settled(60));
    RunParameters other = session.snapshot().parameters;
    other.sigma = 0.35;
    other.alpha = 0.3;
    CHECK(session.apply(other).ok());
    session.step(25);
    REQUIRE(session.wait_until_settled(60));
    other.shrink = 0.6;
    CHECK(session.apply(other).ok());
    session.resume();
    REQUIRE(session.wait_until_settled(120));
    const SessionSnapshot end = session.snapshot();
    REQUIRE(end.phase == SessionPhase::finished);
    CHECK(end.journal->sample_sets().size() == 2);
    CHECK(end.journal->parameters().size() >= 3);
    live.add(digest(*end.journal));
  }
  const ReadBack back = read_back(folder / "run.isorun");
  Digest read;
  read.add(digest(*back.journal));
  CHECK(read.value() == live.value());
  CHECK(replayed_from(folder / "run.isorun").operations == back.journal->steps());
}

TEST_CASE("The recording of a branch replays, and so does that of a branch's branch") {
  const TemporaryFolder folder;
  Session trunk;
  trunk.start(quick("torus"));
  REQUIRE(trunk.wait_until_settled(120));
  const SessionSnapshot whole = trunk.snapshot();
  REQUIRE(whole.phase == SessionPhase::finished);
  const Event early = collapse_of(*whole.journal, Stage::zero_set, 0);
  SessionSnapshot first;
  {
    const Session branch = recorded_branch(whole, early, folder / "first.isorun");
    first = branch.snapshot();
  }
  replayed_from(folder / "first.isorun");
  const Event late = collapse_of(*first.journal, Stage::zero_set, early.step + 20);
  { const Session branch = recorded_branch(first, late, folder / "second.isorun"); }
  const ReplayVerdict verdict = replayed_from(folder / "second.isorun");
  CHECK(verdict.operations > late.step);
}

TEST_CASE("A branch that leaves a run before its end replays, also after parameters were changed") {
  const TemporaryFolder folder;
  Session trunk;
  trunk.start(quick("torus"), nullptr, true);
  REQUIRE(trunk.wait_until_settled(60));
  RunParameters other = trunk.snapshot().parameters;
  other.shrink = 0.65;
  CHECK(trunk.apply(other).ok());
  trunk.run_until([](const Journal& journal, const Event& e) {
    return e.stage == Stage::zero_set && e.operation && journal.steps() % 10 == 0 ? std::string("far enough")
                                                                                  : std::string();
  });
  REQUIRE(trunk.wait_until_settled(120));
  const SessionSnapshot held = trunk.snapshot();
  REQUIRE(held.phase == SessionPhase::paused);
  const Event at = collapse_of(*held.journal, Stage::zero_set, 0);
  { const Session branch = recorded_branch(held, at, folder / "branch.isorun"); }
  replayed_from(folder / "branch.isorun");
}
