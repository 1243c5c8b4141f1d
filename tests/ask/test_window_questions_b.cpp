// Sessions of the window that answer questions 9 to 16, 19 and 20 by their numbers: elements, work, topology,
// validity.
#include "support/window_script.h"

#include <doctest/doctest.h>

using isoscope::test::run_window;

TEST_CASE("elements tell why they violate, who mends them and which parameters would help") {
  CHECK(run_window("elements", R"(
wait settled
seek 30
expect violations.misoriented > 0
key N
expect selection == tet and tet.misoriented == on and tet.tests > 0 and tet.failed_tests > 0
set inspect.shrink 0.02
expect tet.misoriented == off and tet.failed_tests == 0
set inspect.shrink 0
expect tet.misoriented == on
expect advice.shrink < 0.7
next-violation flat
expect selection == tet and tet.height < tet.height_limit and tet.height == tet.gap
expect advice.sigma < 0.5
key Shift+N
expect tet.height < tet.height_limit
pick-worst
expect sample.class == bad and sample.error > 1 and sample.f != 0
expect sample.fixer != none and advice.alpha == none
quit
)",
                   "gallery:bracket --until refinement") == 0);
}

TEST_CASE("histories list what happened and L goes to the last change") {
  CHECK(run_window("histories", R"(
wait settled
seek 30
wait settled
pick-worst
wait settled
key H
wait settled
expect history.changes > 1 and history.rows == history.changes
expect history.first_step < 30
key L
expect state_step < 30 and selection == sample
key L
expect state_step < 20
stage zero-set
next-event rejection zero-set
expect history.attempts > 0 and history.rejections > 0 and history.rejections <= history.attempts
expect history.first_kind == born
next-event collapse zero-set
expect history.last_kind == gone and history.attempts > history.rejections
pick vertex 20
expect history.first_kind == born and history.places > 0
clear
expect history.rows == none
quit
)",
                   "gallery:bracket --effort 0") == 0);
}

TEST_CASE("work is mapped, timed and explained, topology and validity are judged") {
  CHECK(run_window("state", R"(
wait settled
work
expect work.total > 1000 and work.cells > 100 and work.hottest > 1
expect work.seconds > 0 and work.decisions > work.total
set work.kind insertions
expect work.total > 100
set stall.last 200
expect stall.attempts == 200 and stall.since_accepted > 0 and stall.accepted < 200
expect stall.reason != none and stall.places > 0
look-at-place stall 0
topology
expect topology.verdict == on and topology.components == 1 and topology.genus == 3
expect topology.expected_genus == 3 and topology.boundaries == 2 and topology.wrong == 0
expect topology.loop > 0 and topology.thickening == on
seek 30
check
expect check.step == 30 and check.broken == 0 and check.delaunay == holds and check.samples == holds
expect check.contained == not-due and check.closed == holds
end
find-invalid
expect check.broken == 0 and check.contained == holds and check.search == all-valid
expect check.tetrahedra == absent and check.topology == holds
quit
)",
                   "gallery:bracket --effort 0") == 0);
}

TEST_CASE("an edge that stays for its normals is told which shrink would help") {
  CHECK(run_window("edge-advice", R"(
wait settled
next-event normals zero-set
expect event.reason == normals and advice.shrink == none
advice
expect advice.sigma == none and advice.alpha == none
quit
)",
                   "gallery:bracket --until zero-set") == 0);
}
