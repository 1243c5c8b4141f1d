// The stages of the simplification: every state valid, every decision in the journal, any step both ways.
#include "simplify/simplified.h"

#include "base/parallel.h"
#include "collapse/collapse_evaluator.h"
#include "collapse/collapse_stage.h"
#include "journal/playback.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

/// With an improver that relaxes but repairs nothing: its own tests go further.
SimplificationParameters until(Stage stage) {
  SimplificationParameters p;
  p.effort = 1;
  p.until = stage;
  return p;
}

} // namespace

TEST_CASE("each stage leaves a valid Z with fewer vertices") {
  std::size_t last = 0xffffffff;
  for (const Stage stage : {Stage::gamma, Stage::zero_set, Stage::all, Stage::improve}) {
    CAPTURE(std::string(name(stage)));
    Simplified s("torus", {.percent = 4}, until(stage));
    CHECK(s.run());
    check_zero_set(s);
    const std::size_t vertices = extract_zero_set(s.complex()).vertices.size();
    CHECK(vertices <= last);
    last = vertices;
    const auto& operations = s.bench.journal->operations();
    CHECK(operations[operations.size() - 1].figures.zero_set_vertices == vertices);
  }
}

TEST_CASE("the paper's mode simplifies too, and keeps every sample's class") {
  Simplified s("sphere", {.percent = 8, .sigma_ratio = 0.2, .certified = false}, until(Stage::all));
  CHECK(s.run());
  check_zero_set(s);
  SampleSets sets(s.bench.samples->positions);
  sets.assign_all(s.complex());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const TetId t = sets.tet_of(SampleId(i));
    wrong += t.valid() && s.complex().tet(t).side * s.bench.samples->labels[i] < 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("replay reaches the simplification's own state, valid on the way, and undoing everything nothing") {
  Simplified s("bracket", {.percent = 2}, until(Stage::improve));
  s.run();
  Playback playback(s.bench.journal);
  const Step steps = s.bench.journal->steps();
  playback.seek(steps);
  CHECK(playback.complex() == s.complex());
  for (Step k = steps; k > 0; k -= std::min<Step>(k, 61)) {
    playback.seek(k);
    CHECK(check_complex(playback.complex()).empty());
    const ZeroSet z = extract_zero_set(playback.complex());
    const Operation& operation = s.bench.journal->operations()[k - 1];
    CHECK(operation.figures.zero_set_vertices == z.vertices.size());
    if (playback.complex().form != ZeroForm::interpolated)
      CHECK(check_topology(z, s.bench.expected).as_expected);
  }
  playback.seek(0);
  CHECK(playback.complex() == Complex{});
}

TEST_CASE("every thread count writes the same journal") {
  std::uint64_t expected = 0;
  for (const unsigned threads : {1u, 5u}) {
    const ThreadLimit limit(threads);
    Simplified s("torus", {.percent = 5}, until(Stage::improve));
    s.run();
    if (expected == 0) expected = digest(*s.bench.journal);
    CHECK(digest(*s.bench.journal) == expected);
  }
}

TEST_CASE("told to stop at any operation it leaves a valid Z and can go on") {
  for (const std::size_t after : {1u, 40u, 150u, 400u}) {
    CAPTURE(after);
    Simplified s("sphere", {.percent = 4}, until(Stage::improve));
    const Step refined = s.bench.journal->steps();
    s.bench.gate->script = [&](const Journal& journal, const Event&) {
      return journal.steps() == refined + after ? Gate::Verdict::stop : Gate::Verdict::go_on;
    };
    const bool finished = s.run();
    check_zero_set(s);
    s.bench.gate->script = nullptr;
    if (!finished) CHECK(s.run());
    check_zero_set(s);
  }
}

TEST_CASE("the evaluator is pure, and full detail decides like the short one") {
  Simplified s("torus", {.percent = 3}, until(Stage::tessellation));
  s.run();
  const LiveComplex live(s.complex(), nullptr);
  const NearestSample nearest(s.bench.samples->positions, s.bench.samples->labels);
  const EvaluationContext context{*s.bench.volume, &nearest, s.bench.criteria};
  CollapseSettings settings;
  settings.kind = EdgeKind::mixed;
  std::size_t looked = 0, possible = 0;
  for (std::size_t i = 0; i < s.complex().tets.size(); i += 37) {
    const Tet& t = s.complex().tets[i];
    if (!t.alive()) continue;
    for (const auto& [a, b] : {std::pair(t.v[0], t.v[1]), std::pair(t.v[2], t.v[3])}) {
      const VertexId stays = live.complex().value(b) == 0 ? b : a, goes = stays == a ? b : a;
      const EdgeStar star = live.star(stays, goes, CostRing::one);
      const auto shortly = evaluate_collapse(star, settings, context, EvaluationDetail::decision);
      const auto again = evaluate_collapse(star, settings, context, EvaluationDetail::decision);
      const auto fully = evaluate_collapse(star, settings, context, EvaluationDetail::full);
      CHECK(shortly.rejected == again.rejected);
      CHECK(shortly.target == again.target);
      CHECK(shortly.possible() == fully.possible());
      if (shortly.possible()) {
        CHECK(shortly.target == fully.target);
        CHECK(shortly.cost == fully.cost);
        CHECK(fully.candidates.size() == fully.tried);
        CHECK(evaluate_target(star, fully.target, settings, context).possible());
        ++possible;
      } else {
        CHECK(shortly.rejected == fully.rejected);
      }
      ++looked;
    }
  }
  CHECK(looked > 20);
  CHECK(possible > 0);
}
