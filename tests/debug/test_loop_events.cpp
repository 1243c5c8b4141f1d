// Loops of an open surface have lanes of their own, the longest, and share one, and the list can be limited
// to each.
#include "debug/filtered_events.h"
#include "debug/loop_events.h"
#include "questions/rim_questions.h"
#include "run/complete_run.h"
#include "tolerance/open_shapes.h"
#include "tolerance/rim.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A square with nine holes of the same size, cut and no further: ten loops.
std::unique_ptr<CompleteRun> cut_square() {
  RunParameters parameters;
  parameters.tolerance = {2.5, true};
  parameters.until = Stage::rim;
  auto run = std::make_unique<CompleteRun>(parameters);
  const auto is_hole = [](double t) { return static_cast<int>(t * 13) % 4 == 2; };
  run->soup = shared(grid_sheet(13, [&](double x, double y) { return !is_hole(x) || !is_hole(y); }));
  return run;
}

LoopEvents gathered(const CompleteRun& run, std::size_t budget) {
  LoopEvents loops;
  do loops.update(run.journal, run.scene, budget);
  while (!loops.complete());
  return loops;
}

} // namespace

TEST_CASE("the longest loops have lanes, the others one; what is gathered in small steps is the same") {
  const std::unique_ptr<CompleteRun> made = cut_square();
  CompleteRun& run = *made;
  REQUIRE(run.run());
  REQUIRE(open_rim(*run.scene)->loops().size() == 10);
  const LoopEvents loops = gathered(run, 20000);
  REQUIRE(loops.lanes().size() == LoopEvents::most_single + 1);
  CHECK(loops.lanes().back() == other_loops);
  CHECK(loops.title(other_loops) == "2 other holes");
  CHECK(loops.title(3) == "hole 4");
  const auto rim_loops = open_rim(*run.scene)->loops();
  const auto longest = std::max_element(rim_loops.begin(), rim_loops.end(),
                                        [](const auto& a, const auto& b) { return a.length < b.length; });
  CHECK(loops.lanes().front() == longest - rim_loops.begin());

  const Step end = run.journal->steps() + 1;
  std::size_t splits = 0, cuttings = 0;
  for (std::size_t i = 0; i < run.journal->events().size(); ++i)
    splits += run.journal->events()[i].kind == EventKind::split ? 1u : 0u;
  const LoopEvents slowly = gathered(run, 50);
  for (const std::uint32_t loop : loops.lanes()) {
    CHECK(loops.events(loop).size() > 4);
    CHECK(loops.events(loop) == slowly.events(loop));
    CHECK(loops.count(loop, 0, end) == loops.events(loop).size());
    cuttings += loops.count(loop, LoopWork::cutting, 0, end);
  }
  // Each split is of one lane, the cut of all.
  CHECK(splits + loops.lanes().size() == cuttings);

  FilteredEvents listed;
  EventQuery query;
  query.chosen.loop = other_loops;
  query.loops = &loops;
  CHECK_FALSE(query.chosen.everything());
  do listed.update(run.journal, query, 700);
  while (!listed.complete());
  CHECK(listed.rows() == loops.events(other_loops));
  CHECK(loops.touches(other_loops, listed.rows().front()));
  CHECK_FALSE(loops.touches(other_loops, 0));
}

TEST_CASE("names of lanes stand for loops; a closed surface has none") {
  CHECK(loop_lane_name(2) == "loop-3");
  CHECK(loop_of_lane("loop-3") == 2u);
  CHECK(loop_of_lane(loop_lane_name(other_loops)) == other_loops);
  for (const char* wrong : {"loop-0", "loop-", "loop-x", "loops", "split"}) CHECK_FALSE(loop_of_lane(wrong));

  CompleteRun run(gallery_parameters("sphere"));
  REQUIRE(run.prepare());
  LoopEvents loops;
  loops.update(run.journal, run.scene);
  CHECK(loops.complete());
  CHECK(loops.lanes().empty());
  CHECK_FALSE(loops.has(0));
  CHECK_FALSE(loops.has(other_loops));
  CHECK(loops.events(0).empty());
}
