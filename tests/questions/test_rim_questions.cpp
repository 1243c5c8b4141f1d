// Why samples are over the rim, what became of holes step by step, and strata of edges with what was judged.
#include "questions/rim_questions.h"

#include "base/labels.h"
#include "journal/playback.h"
#include "mesh/incidence.h"
#include "mesh/zero_curves.h"
#include "questions/edge_standing.h"
#include "questions/state_at.h"
#include "run/open_run_checks.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::unique_ptr<CompleteRun> finished(TriangleSoup soup, double percent, const char* fill) {
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.until = Stage::zero_set;
  parameters.fill.holes = fill;
  return finished_run(std::move(parameters), std::move(soup));
}

/// The first step after a stage began.
Step beginning_of(const Journal& journal, Stage stage) {
  for (std::size_t i = 0; i < journal.events().size(); ++i)
    if (journal.events()[i].kind == EventKind::stage_begin && journal.events()[i].stage == stage)
      return journal.events()[i].step;
  FAIL("no such stage");
  return 0;
}

} // namespace

TEST_CASE("a square with a hole: boundary samples name the border, holes are ahead, kept, and filled") {
  const auto run = finished(square_with_hole(), 4, "none");
  const auto end = state_at(*run, run->journal->steps());
  REQUIRE_FALSE(end->samples->over_rim.empty());
  std::size_t at_vertices = 0;
  for (const Vec3 p : end->samples->over_rim) {
    const auto x = inspect_rim(*run->scene, p);
    REQUIRE(x);
    CHECK(x->over_rim);
    CHECK(x->to_rim == doctest::Approx(x->distance));
    CHECK(x->distance == doctest::Approx(0.95 * run->scene->delta).epsilon(1e-3));
    // The border that it names has the place of the rim.
    const auto& points = run->scene->input->points;
    const Segment3 edge{points[(*x->edge)[0]], points[(*x->edge)[1]]};
    CHECK(distance_to(edge, x->on_rim) < 1e-6);
    at_vertices += x->at_vertex() ? 1u : 0u;
  }
  CHECK(at_vertices >= 4); // before the corners of the square
  for (std::size_t i = 0; i < end->samples->size(); i += 37) {
    const auto x = inspect_rim(*run->scene, end->samples->positions[i]);
    REQUIRE(x);
    CHECK_FALSE(x->over_rim);
    CHECK(x->to_rim > x->distance);
  }

  const auto before = report_rim(*state_at(*run, beginning_of(*run->journal, Stage::rim)), *run->scene);
  REQUIRE(before);
  CHECK(before->loops.size() == 2);
  CHECK(before->count(HoleState::ahead) == 2);
  const auto kept = report_rim(*end, *run->scene);
  CHECK(kept->count(HoleState::kept) == 2);
  CHECK(kept->bridged.empty());
  double length = 0;
  for (const Segment3& s : kept->loops[0].pieces) length += distance(s[0], s[1]);
  CHECK(length == doctest::Approx(kept->loops[0].loop.length));

  const std::uint32_t inner = kept->loops[0].loop.length < kept->loops[1].loop.length ? 0 : 1;
  const auto filled = finished(square_with_hole(), 4, std::to_string(inner + 1).c_str());
  const auto report = report_rim(*state_at(*filled, filled->journal->steps()), *filled->scene);
  CHECK(report->loops[inner].state == HoleState::filled);
  CHECK(report->loops[1 - inner].state == HoleState::kept);
}

TEST_CASE("a slit that Ω closes is listed as bridged; a closed surface has no rim") {
  const auto run = finished(slit_square(), 4, "none");
  const auto report = report_rim(*state_at(*run, run->journal->steps()), *run->scene);
  REQUIRE(report);
  CHECK(report->loops.size() == 1);
  REQUIRE_FALSE(report->bridged.empty());
  CHECK(report->bridged.front().length > 5 * run->scene->delta);
  CHECK_FALSE(report->bridged.front().meets_wall);

  CompleteRun closed(gallery_parameters("sphere"));
  REQUIRE(closed.prepare());
  CHECK(open_rim(*closed.scene) == nullptr);
  CHECK_FALSE(inspect_rim(*closed.scene, {0, 0, 2}));
}

TEST_CASE("edges of two rooms: sheets, the triple curve, and the link conditions that were asked") {
  CompleteRun run(complete_parameters("two-rooms"));
  run.parameters.until = Stage::tessellation;
  REQUIRE(run.run());
  const Complex complex = replayed(*run.journal);
  const Incidence incidence(complex);
  const ZeroSet zero = extract_zero_set(complex);
  const auto standing = [&](std::uint32_t a, std::uint32_t b) {
    const EdgeStar star = gather_edge_star(complex, incidence, zero.vertices[a].negative,
                                           zero.vertices[b].negative, CostRing::one);
    return edge_standing(star, check_link(star, true));
  };
  const ZeroCurves curves = zero_curves(zero);
  REQUIRE(curves.triple.size() > 8);
  for (const auto& [a, b] : curves.triple) {
    const EdgeStanding s = standing(a, b);
    CHECK(s.strata.edge == Stratum::curve);
    CHECK_FALSE(s.strata.border);
    CHECK(s.labels == std::vector<std::int8_t>{1, -1, -2});
    CHECK(s.kept == 3);
    CHECK(facets_at(zero, zero.vertices[a].negative, zero.vertices[b].negative) == 3);
    CHECK(s.dropped == 0);
    CHECK(s.in_sheets != LinkAnswer::not_asked);
    CHECK((s.on_curves == LinkAnswer::not_asked) == (s.in_sheets == LinkAnswer::fails));
  }
  std::size_t sheets = 0;
  for (const ZeroSet::Polygon& p : zero.polygons) {
    const EdgeStanding s = standing(p.v[0], p.v[1]);
    if (s.strata.edge != Stratum::sheet) continue;
    ++sheets;
    CHECK(s.labels.size() == 2);
    CHECK(s.kept == 2);
    if (s.strata.a == Stratum::sheet || s.strata.b == Stratum::sheet)
      CHECK(s.on_curves == LinkAnswer::not_asked);
  }
  CHECK(sheets > 100);
}
