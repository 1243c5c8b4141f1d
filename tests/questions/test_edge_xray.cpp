// The X-ray of edges: asked again at any step, the evaluator says what it said in the run.
#include "questions/edge_xray.h"

#include "journal/describe.h"
#include "run/complete_run.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;

namespace {

/// A finished run of a model, until T is left.
std::unique_ptr<test::CompleteRun> simplified(const std::string& model, Containment containment) {
  RunParameters parameters = test::gallery_parameters(model);
  parameters.containment = containment;
  parameters.until = Stage::all;
  if (containment == Containment::sampled) {
    parameters.sigma = 0.5; // coarse: the test looks at verdicts, not at the result
    parameters.conditions[1] = false;
  }
  auto run = std::make_unique<test::CompleteRun>(parameters);
  REQUIRE(run->run());
  return run;
}

/// Asks again about every nth collapse and rejection; the number of questions and of the same verdicts.
struct Tally {
  std::size_t asked = 0, same = 0, collapses = 0;
};
Tally ask_again(const test::CompleteRun& run, std::size_t stride) {
  Tally tally;
  Playback playback(run.journal);
  const auto samples = run.scene->samples;
  const NearestSample nearest(samples->positions, samples->labels);
  const XrayContext context{*run.scene, *run.journal, run.parameters, &nearest};
  std::shared_ptr<const StateSnapshot> state;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < run.journal->events().size(); ++i) {
    const Event& e = run.journal->events()[i];
    if (e.kind != EventKind::collapse && e.kind != EventKind::rejection) continue;
    if (seen++ % stride != 0) continue;
    const Step step = step_showing(e);
    if (!state || state->step != step) state = make_snapshot(playback, step, {}, nullptr, state.get());
    const auto xray = edge_xray(*state, {e.vertex, e.other, static_cast<std::uint32_t>(i)}, context);
    REQUIRE(xray.has_value());
    CHECK(xray->before == e.operation);
    REQUIRE(xray->agrees.has_value());
    ++tally.asked;
    tally.same += *xray->agrees;
    tally.collapses += e.operation;
    CAPTURE(describe(*run.journal, e));
    CHECK(*xray->agrees);
    if (e.kind == EventKind::rejection) {
      // Where a search failed, the check behind it tells the same numbers: those of its candidate of least
      // error.
      const auto& checks = xray->attempt.checks;
      const auto is_failed = [](const CheckVerdict& c) { return c.state == CheckVerdict::State::failed; };
      const auto first = std::find_if(checks.begin(), checks.end(), is_failed);
      REQUIRE(first != checks.end());
      if (first == &xray->attempt.check(CollapseCheck::candidates) && xray->attempt.tried > 0) {
        const auto behind = std::find_if(first + 1, checks.end(), is_failed);
        REQUIRE(behind != checks.end());
        CHECK(behind->value == first->value);
        CHECK(behind->limit == first->limit);
        CHECK(behind->witness == first->witness);
      }
    } else {
      CHECK(xray->attempt.kernel->contains(xray->attempt.target));
      CHECK(xray->kernel.volume > 0);
      CHECK(xray->candidates[static_cast<std::size_t>(Reason::none)] == 1);
    }
  }
  return tally;
}

/// Made once: several tests look at it, none changes it.
const test::CompleteRun& certified_sphere() {
  static const std::unique_ptr<test::CompleteRun> run = simplified("sphere", Containment::certified);
  return *run;
}

} // namespace

TEST_CASE("the verdicts of a certified run are found again at every step") {
  const Tally tally = ask_again(certified_sphere(), 11);
  CHECK(tally.asked > 30);
  CHECK(tally.collapses > 5);
  CHECK(tally.same == tally.asked);
}

TEST_CASE("the verdicts of a sampled run are found again, samples and all") {
  const auto finished = simplified("sphere", Containment::sampled);
  const Tally tally = ask_again(*finished, 17);
  CHECK(tally.asked > 30);
  CHECK(tally.collapses > 5);
  CHECK(tally.same == tally.asked);
}

TEST_CASE("an edge is judged by what is asked for, and only where it is") {
  const test::CompleteRun& run = certified_sphere();
  Playback playback(run.journal);
  const Step last = run.journal->steps();
  const auto state = make_snapshot(playback, last, {}, nullptr);
  REQUIRE(state->complex.form == ZeroForm::embedded);
  const XrayContext context{*run.scene, *run.journal, run.parameters, nullptr};
  const ZeroSet& zero = state->zero_set;
  REQUIRE(!zero.polygons.empty());
  const VertexId a = zero.vertices[zero.polygons[0].v[0]].negative,
                 b = zero.vertices[zero.polygons[0].v[1]].negative;
  const auto general = edge_xray(*state, {a, b, std::nullopt, XrayTarget::general}, context);
  const auto halfedge = edge_xray(*state, {b, a, std::nullopt, XrayTarget::halfedge}, context);
  REQUIRE(general.has_value());
  REQUIRE(halfedge.has_value());
  CHECK(general->attempt.kind == EdgeKind::zero);
  CHECK(!general->halfedge);
  CHECK(halfedge->halfedge);
  CHECK(halfedge->attempt.tried <= 2);
  CHECK(halfedge->attempt.a == general->attempt.a); // whichever end was named first
  CHECK(!general->agrees.has_value());
  // Pure: the same question, the same answer.
  const auto again = edge_xray(*state, {a, b, std::nullopt, XrayTarget::general}, context);
  CHECK(again->attempt.target == general->attempt.target);
  CHECK(again->attempt.rejected == general->attempt.rejected);
  CHECK(again->candidates == general->candidates);

  CHECK(!edge_xray(*state, {a, a, {}, {}}, context).has_value());
  CHECK(!edge_xray(*state, {a, VertexId(1000000), {}, {}}, context).has_value());
  CHECK(!edge_xray(*state, {a, VertexId(), {}, {}}, context).has_value());
}

TEST_CASE("the event of an edge at a step is the operation there, else a rejection") {
  const test::CompleteRun& run = certified_sphere();
  std::size_t collapses = 0, rejections = 0;
  for (std::size_t i = 0; i < run.journal->events().size(); ++i) {
    const Event& e = run.journal->events()[i];
    if (e.kind == EventKind::collapse) {
      ++collapses;
      CHECK(edge_event(*run.journal, e.step + 1, e.other, e.vertex) == static_cast<std::uint32_t>(i));
    }
    if (e.kind != EventKind::rejection) continue;
    const auto found = edge_event(*run.journal, e.step, e.vertex, e.other);
    REQUIRE(found.has_value());
    CHECK(run.journal->events()[*found].vertex == e.vertex);
    ++rejections;
  }
  CHECK(collapses > 10);
  CHECK(rejections > 10);
  CHECK(!edge_event(*run.journal, 0, VertexId(1), VertexId(2)).has_value());
}
