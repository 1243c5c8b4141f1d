// What is done to each loop of an open surface, against the borders that Z has step by step.
#include "questions/loop_events.h"

#include "mesh/zero_curves.h"
#include "questions/rim_questions.h"
#include "questions/state_at.h"
#include "run/open_run_checks.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::unique_ptr<CompleteRun> improved(TriangleSoup soup, double percent, const char* fill) {
  RunParameters parameters;
  parameters.tolerance = {percent, true};
  parameters.effort = 0;
  parameters.fill.holes = fill;
  return finished_run(std::move(parameters), std::move(soup));
}

/// Edges of the border of Z by the loop they run along.
std::vector<std::size_t> border_edges(const CompleteRun& run, Step step, const Rim& rim) {
  const auto state = state_at(run, step);
  std::vector<std::size_t> edges(rim.loops().size(), 0);
  const auto place = [&](std::uint32_t v) { return state->zero_set.vertices[v].position; };
  for (const auto& [a, b] : zero_curves(state->zero_set).border)
    ++edges[rim.loop_near(0.5 * (place(a) + place(b)))];
  return edges;
}

struct Found {
  std::vector<std::array<std::size_t, loop_work_count>> work; ///< by loop
  Step after_cut = 0;
  std::size_t splits = 0;
};

Found loop_events(const CompleteRun& run, const Rim& rim) {
  Found found;
  found.work.resize(rim.loops().size());
  for (std::size_t i = 0; i < run.journal->events().size(); ++i) {
    const Event& e = run.journal->events()[i];
    if (e.kind == EventKind::split) ++found.splits;
    if (e.kind == EventKind::cut) found.after_cut = e.step + 1;
    for (const std::uint32_t loop : loops_touched(*run.journal, e, rim))
      ++found.work.at(loop).at(static_cast<std::size_t>(*loop_work(e.kind)));
  }
  return found;
}

} // namespace

TEST_CASE("Each loop loses as many border edges as it has collapses, in T and after it") {
  for (const bool sphere : {false, true}) {
    const auto run =
        sphere ? improved(ball_with_holes(), 4, "none") : improved(square_with_hole(), 4, "none");
    const Rim* const rim = open_rim(*run->scene);
    REQUIRE(rim != nullptr);
    const Found found = loop_events(*run, *rim);
    REQUIRE(found.work.size() == (sphere ? 4 : 2));
    const auto cut = border_edges(*run, found.after_cut, *rim);
    const auto end = border_edges(*run, run->journal->steps(), *rim);
    std::size_t cutting = 0;
    for (std::size_t loop = 0; loop < cut.size(); ++loop) {
      CAPTURE(loop);
      const auto& [cuts, collapses, fillings] = found.work[loop];
      CHECK(cuts > 10);
      CHECK(cut[loop] > end[loop]);
      CHECK(collapses == cut[loop] - end[loop]);
      CHECK(fillings == 0);
      cutting += cuts;
    }
    // Each split is of one loop, the cut of all.
    CHECK(cutting == found.splits + cut.size());
  }
}

TEST_CASE("A filling is one of the loops that it closes") {
  const auto run = improved(ball_with_holes(), 4, "1,3");
  const Rim* const rim = open_rim(*run->scene);
  REQUIRE(rim != nullptr);
  const Found found = loop_events(*run, *rim);
  REQUIRE(found.work.size() == 4);
  for (std::size_t loop = 0; loop < 4; ++loop) CHECK(found.work[loop][2] == (loop % 2 == 0 ? 1 : 0));
}
