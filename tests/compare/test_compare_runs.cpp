// Two runs compared: the same, a branch, other parameters; and how their steps are aligned.
#include "compare/compare_runs.h"

#include "run/complete_run.h"
#include "run/session.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>

using namespace isoscope;
using namespace isoscope::test;

namespace {

RunComparison compare(const CompleteRun& a, const CompleteRun& b) {
  return compare_runs(a.parameters, *a.journal, b.parameters, *b.journal, RunControl());
}

/// Runs are made once each.
const CompleteRun& made(const std::string& key, const RunParameters& parameters) {
  static std::map<std::string, std::unique_ptr<CompleteRun>> runs;
  auto& run = runs[key];
  if (!run) {
    run = std::make_unique<CompleteRun>(parameters);
    REQUIRE(run->run());
  }
  return *run;
}

/// To the last stage with the least effort.
RunParameters torus_parameters() {
  RunParameters parameters = complete_parameters("torus");
  parameters.effort = 0;
  return parameters;
}

const CompleteRun& torus() {
  return made("torus", torus_parameters());
}

/// A journal of stages with so many operations each, and nothing in them.
std::vector<StageStretch> stretches(std::initializer_list<std::pair<Stage, Step>> stages) {
  std::vector<StageStretch> list;
  Step at = 0;
  for (const auto& [stage, steps] : stages) {
    list.push_back({stage, at, at + steps});
    at += steps;
  }
  return list;
}

void check_monotone(const RunAlignment& alignment, Step steps_a, Step steps_b) {
  for (Step a = 1; a <= steps_a; ++a) CHECK(alignment.to_b(a) >= alignment.to_b(a - 1));
  for (Step b = 1; b <= steps_b; ++b) CHECK(alignment.to_a(b) >= alignment.to_a(b - 1));
  CHECK(alignment.to_b(steps_a) == steps_b);
  CHECK(alignment.to_a(steps_b) == steps_a);
  for (Step s = 0; s < alignment.common(); ++s) {
    CHECK(alignment.to_b(s) == s);
    CHECK(alignment.to_a(s) == s);
  }
}

} // namespace

TEST_CASE("two runs with the same parameters do not differ, on any number of threads") {
  RunParameters parameters = torus_parameters();
  parameters.threads = 3;
  const CompleteRun& again = made("torus, 3 threads", parameters);
  const RunComparison found = compare(torus(), again);
  CHECK(found.same());
  CHECK(found.parameters.empty());
  CHECK(found.events_a == torus().journal->events().size());
  CHECK(found.decisions.rows.empty());
  CHECK(found.alignment.common() == torus().journal->steps());
  check_monotone(found.alignment, torus().journal->steps(), again.journal->steps());
  REQUIRE(found.stages.size() == 6);
  for (const StageComparison& row : found.stages) {
    REQUIRE((row.a && row.b));
    CHECK(row.a->zero_set_vertices == row.b->zero_set_vertices);
    CHECK(row.a->operations == row.b->operations);
    CHECK(row.a->rejected == row.b->rejected);
  }
}

TEST_CASE("a branch differs from its trunk exactly where it left it") {
  const CompleteRun& trunk = torus();
  const Journal& journal = *trunk.journal;
  std::vector<std::uint32_t> collapses;
  for (std::uint32_t i = 0; i < journal.events().size(); ++i)
    if (journal.events()[i].kind == EventKind::collapse && journal.events()[i].stage == Stage::zero_set)
      collapses.push_back(i);
  REQUIRE(collapses.size() > 12);
  // What the trunk did some steps later is done at once.
  const Step step = journal.events()[collapses[2]].step;
  SessionSnapshot branch;
  Session session;
  for (std::size_t later = 5; later < 12 && !branch.result; ++later) {
    const Event& e = journal.events()[collapses[later]];
    session.start_branch({trunk.journal, step, e.vertex, e.other, e.point}, trunk.parameters, *trunk.scene,
                         1);
    REQUIRE(session.wait_until_settled(60));
    branch = session.snapshot();
  }
  REQUIRE(branch.result);
  const RunComparison found =
      compare_runs(trunk.parameters, journal, branch.parameters, *branch.journal, RunControl());
  CHECK(!found.same());
  CHECK(found.parameters.empty());
  CHECK(!found.measure);
  REQUIRE(found.decision);
  CHECK(found.decision->step == step);
  CHECK(found.decision->in_a);
  CHECK(found.decision->in_b);
  CHECK(found.alignment.common() == step);
  CHECK(describe(*found.decision, *branch.journal, true).find("branched at step " + std::to_string(step)) !=
        std::string::npos);
  check_monotone(found.alignment, journal.steps(), branch.journal->steps());
  // Most of what comes after is the same at other places, and nothing before the stage of the branch differs.
  CHECK(found.decisions.both() > 0);
  REQUIRE(!found.decisions.stages.empty());
  CHECK(found.decisions.stages.front().stage == Stage::zero_set);
  CHECK(found.decisions.both() + found.decisions.only_a() + found.decisions.only_b() >= journal.steps() / 4);
}

TEST_CASE("another α is first another limit, then another decision") {
  RunParameters parameters = torus_parameters();
  parameters.alpha = 0.3;
  const CompleteRun& other = made("torus, α 0.3", parameters);
  const RunComparison found = compare(torus(), other);
  REQUIRE(found.parameters.size() == 1);
  CHECK(found.parameters[0] == FieldDifference{"α", "0.2", "0.3"});
  CHECK(found.same_samples);
  REQUIRE(found.measure);
  REQUIRE(found.decision);
  CHECK(found.measure->event < found.decision->event);
  const Journal &a = *torus().journal, &b = *other.journal;
  const Event &x = a.events()[found.measure->event], &y = b.events()[found.measure->event];
  CHECK(x.limit == doctest::Approx(0.8));
  CHECK(y.limit == doctest::Approx(0.7));
  CHECK(x.point == y.point);
  // All decisions before are the same, and this one is not.
  for (std::uint32_t i = 0; i < found.decision->event; ++i)
    CHECK(same_decision(a, a.events()[i], b, b.events()[i]));
  CHECK(!same_decision(a, a.events()[found.decision->event], b, b.events()[found.decision->event]));
  CHECK(a.events()[found.decision->event].step == found.decision->step);
  check_monotone(found.alignment, a.steps(), b.steps());
}

TEST_CASE("another σ gives other samples and another first point") {
  RunParameters parameters = torus_parameters();
  parameters.sigma = 0.4;
  const CompleteRun& other = made("torus, σ 0.4", parameters);
  const RunComparison found = compare(torus(), other);
  REQUIRE(found.parameters.size() == 1);
  CHECK(found.parameters[0].name == "σ/δ");
  CHECK(found.parameters[0].a == "0.5");
  CHECK(found.parameters[0].b == "0.4");
  CHECK(!found.same_samples);
  CHECK(found.samples_b > found.samples_a);
  REQUIRE(found.decision);
  CHECK(torus().journal->events()[found.decision->event].stage == Stage::refinement);
  CHECK(found.decision->step <= 2);
  // The table holds every operation of the refinement on one side or the other.
  REQUIRE(!found.decisions.stages.empty());
  const StageDecisions& refinement = found.decisions.stages.front();
  CHECK(refinement.stage == Stage::refinement);
  const auto insertions = [](const Journal& journal, std::size_t from) {
    std::size_t n = 0;
    for (std::size_t i = from; i < journal.events().size(); ++i)
      n += journal.events()[i].kind == EventKind::insertion ? 1 : 0;
    return n;
  };
  CHECK(refinement.both + refinement.only_a == insertions(*torus().journal, found.decision->event));
  CHECK(refinement.both + refinement.only_b == insertions(*other.journal, found.decision->event));
}

TEST_CASE("rows name the decision and what the other run said of the same edge") {
  // The same four vertices; one run collapses the first edge, the other one the second edge and refuses the
  // first, whose ends it names the other way round. Then both move a vertex and collapse there.
  Journal a, b;
  const auto edge = [](EventKind kind, std::uint32_t kept, std::uint32_t removed) {
    Event e;
    e.kind = kind;
    e.stage = Stage::zero_set;
    e.vertex = VertexId(kept);
    e.other = VertexId(removed);
    return e;
  };
  for (Journal* journal : {&a, &b}) {
    Event box;
    box.kind = EventKind::insertion;
    Delta four;
    four.added_vertices.resize(4);
    for (std::size_t i = 0; i < 4; ++i)
      four.added_vertices[i].position.x = std::array<double, 4>{0, 1, 4, 6}[i];
    journal->add_operation(box, four, {});
  }
  a.add_operation(edge(EventKind::collapse, 0, 1), {}, {});
  b.add_operation(edge(EventKind::collapse, 2, 3), {}, {});
  Event refused = edge(EventKind::rejection, 1, 0);
  refused.reason = Reason::kernel_empty;
  b.add_event(refused);
  b.add_event(refused);
  for (Journal* journal : {&a, &b}) {
    Event moved;
    moved.kind = EventKind::relaxation;
    moved.stage = Stage::improve;
    Delta delta;
    delta.moves.push_back({VertexId(0), {0, 0, 0}, {0, 2, 0}});
    journal->add_operation(moved, delta, {});
    Event repaired = edge(EventKind::repair, journal == &a ? 0 : 2, journal == &a ? 2 : 0);
    repaired.stage = Stage::improve;
    journal->add_operation(repaired, {}, {});
  }
  const DecisionTable table = differing_decisions(a, b, 1, RunControl());
  REQUIRE(table.stages.size() == 2);
  CHECK(table.stages[0].stage == Stage::zero_set);
  CHECK(table.stages[0].only_a == 1);
  CHECK(table.stages[0].only_b == 1);
  CHECK(table.stages[0].both == 0);
  CHECK(table.stages[1].both == 1);
  REQUIRE(table.rows.size() == 2);
  const DecisionDifference &first = table.rows[0], &second = table.rows[1];
  CHECK(first.made_by_a);
  CHECK(first.event == 1);
  CHECK(first.place == Vec3{0.5, 0, 0});
  REQUIRE(first.refusal);
  CHECK(*first.refusal == 3);
  CHECK(!second.made_by_a);
  CHECK(second.place == Vec3{5, 0, 0});
  CHECK(!second.refusal);
  RunControl cancelled;
  cancelled.cancel();
  CHECK(differing_decisions(a, b, 1, cancelled).rows.empty());
}

TEST_CASE("a run that stops differs where it stops") {
  RunParameters parameters = torus_parameters();
  parameters.until = Stage::gamma;
  const CompleteRun& shorter = made("torus until gamma", parameters);
  const RunComparison found = compare(torus(), shorter);
  REQUIRE(found.parameters.size() == 1);
  CHECK(found.parameters[0] == FieldDifference{"until", "improve", "gamma"});
  REQUIRE(found.decision);
  CHECK(!found.measure);
  CHECK(found.decision->in_a);
  CHECK(found.decision->event == found.events_b);
  CHECK(found.decision->in_b == false);
  CHECK(describe(*found.decision, *shorter.journal, false) == "the run ends here");
  CHECK(found.decisions.only_b() == 0);
  CHECK(found.stages.size() == 6);
  CHECK(!found.stages.back().b);
  // Its end stands beside everything that the other one did after.
  CHECK(found.alignment.to_b(torus().journal->steps()) == shorter.journal->steps());
}

TEST_CASE("steps after the first difference belong to the same part of their stage") {
  const auto a = stretches({{Stage::refinement, 100}, {Stage::gamma, 50}, {Stage::all, 10}});
  const auto b = stretches({{Stage::refinement, 200}, {Stage::zero_set, 40}, {Stage::all, 30}});
  const RunAlignment alignment(a, 160, b, 270, 20);
  for (const Step s : {0u, 7u, 20u}) CHECK(alignment.to_b(s) == s);
  CHECK(alignment.to_b(60) == 110); // half of what is left of the refinement
  CHECK(alignment.to_a(110) == 60);
  CHECK(alignment.to_b(100) == 200);
  CHECK(alignment.to_b(155) == 255); // half of the last stage
  CHECK(alignment.to_b(160) == 270);
  CHECK(alignment.to_b(999) == 270);
  CHECK(alignment.to_a(999) == 160);
  check_monotone(alignment, 160, 270);
}

TEST_CASE("a stage that one run left out stands still in it") {
  const auto a = stretches({{Stage::refinement, 10}, {Stage::gamma, 10}, {Stage::zero_set, 10}});
  const auto b = stretches({{Stage::refinement, 10}, {Stage::zero_set, 20}});
  const RunAlignment alignment(a, 30, b, 30, 10);
  CHECK(alignment.to_b(15) == 10);
  CHECK(alignment.to_b(20) == 10);
  CHECK(alignment.to_b(25) == 20);
  CHECK(alignment.to_a(10) == 20);
  CHECK(alignment.to_a(9) == 9);
}

TEST_CASE("stages are paired in order, also where one comes twice") {
  using S = Stage;
  const auto pairs =
      pair_stages({S::refinement, S::gamma, S::refinement}, {S::refinement, S::all, S::refinement});
  REQUIRE(pairs.size() == 4);
  CHECK(pairs[0] == StagePair{0, 0});
  CHECK(pairs[1] == StagePair{1, std::nullopt});
  CHECK(pairs[2] == StagePair{std::nullopt, 1});
  CHECK(pairs[3] == StagePair{2, 2});
  CHECK(pair_stages({}, {S::all}).size() == 1);
  CHECK(RunAlignment().to_b(5) == 0);
}
