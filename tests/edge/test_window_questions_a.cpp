// The questions that are asked of an edge, in the real window: each with its numbers.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <string>

using isoscope::test::run_window;

namespace {

/// What is asked about are stages before the improver: it has the least effort, where no other is said.
const std::string bracket = "gallery:bracket --size 1440x900 --effort 0";

} // namespace

TEST_CASE("1 and 5: why did this collapse fail, and what rejected each target?") {
  CHECK(run_window("question-1", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
expect xray.agrees == on and xray.verdict == outside-tolerance
expect xray.link == passed and xray.zero-link == passed and xray.kernel == passed
expect xray.containment == failed and xray.containment.value > xray.containment.limit
expect xray.containment.value == event.value and xray.containment.limit == event.limit
expect xray.normals.value > 0 and xray.kernel.value == xray.kernel_radius
expect xray.kernel.seconds > 0 and xray.candidates.seconds > 0 and xray.containment.seconds > 0
expect xray.rejected.outside-tolerance >= 1
witness kernel
witness containment
next-candidate
expect candidate == 0 and candidate.reason == outside-tolerance
expect candidate.value == what-if.containment.value and what-if.verdict == outside-tolerance
expect what-if.containment.before < what-if.containment.value and what-if.facets_outside >= 1
next-candidate
previous-candidate
key I
what-if off
expect what-if.verdict == none
quit
)",
                   bracket) == 0);
}

TEST_CASE("2, 3 and 4: the link, an empty kernel, a kernel") {
  CHECK(run_window("question-2", R"(
wait settled
stage zero-set
next-event link-condition zero-set
expect xray.link == failed and xray.offenders_t >= 1 and xray.agrees == on
expect xray.offenders > xray.offenders_t and xray.offenders_zero >= 1
expect xray.kernel != skipped
witness link
stage gamma
next-event kernel-empty gamma
next-event kernel-empty gamma
next-event kernel-empty gamma
expect xray.verdict == kernel-empty and xray.agrees == on
expect xray.kernel_witnesses >= 2 and xray.kernel_witnesses <= 4
expect xray.missing_slack > 0 and xray.missing_slack_delta > 0.01
expect event.value < 0 and xray.kernel.value == event.value
set xray.push 1
expect xray.push == 1
what-if center
expect what-if.verdict == kernel-empty and what-if.slack < 0
stage zero-set
next-event collapse zero-set
expect xray.kernel_volume > 0 and xray.kernel_radius > 0 and xray.kernel_faces >= 4
expect xray.half_spaces >= xray.kernel_faces
quit
)",
                   bracket) == 0);
}

TEST_CASE("6 and 8: what the search left out, rightly, and what the constraints cost") {
  CHECK(run_window("question-6", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
expect xray.agrees == on and xray.psi_count >= 1
set xray.target octree
expect xray.agrees == unasked and xray.cells_visited > 20 and xray.cells_pruned >= 0
expect xray.pruned_judged >= 1 and xray.pruned_wrong == 0 and xray.costlier_wrong == 0
set xray.target automatic
next-event collapse quadric-optimum zero-set
expect xray.verdict == possible and xray.cost >= xray.optimum_cost and xray.cost_ratio >= 1
expect xray.optimum_distance >= 0
what-if best
expect what-if.verdict == possible
what-if optimum
expect what-if.cost == xray.optimum_cost
quit
)",
                   bracket) == 0);
}

TEST_CASE("7: what would happen if the target were here, and do it") {
  CHECK(run_window("question-7", R"(
wait settled
stage zero-set
next-event collapse zero-set
what-if
expect what-if.verdict == possible and what-if.cost == xray.cost
nudge-right
nudge-up
expect what-if.verdict != none and what-if.cost != xray.cost
what-if 1000 1000 1000
expect what-if.verdict == no-candidate and what-if.slack < -100 and what-if.containment == failed
expect what-if.candidates == failed and what-if.witness == skipped
what-if vertex
expect what-if.slack > 0 and what-if.candidates == passed
what-if found
expect what-if.verdict == possible and what-if.facets_outside == 0
expect runs == 1 and branched == off
do-it
wait settled
expect runs == 2 and branched == on and phase == finished and certified == on
stage zero-set
next-event collapse user
expect event.reason == user and facets_removed > 0 and vertices_moved > 0
other-run
wait settled
expect branched == off and certified == on
other-run
wait settled
expect branched == on
quit
)",
                   bracket) == 0);
}

TEST_CASE("a target is dragged with the mouse, at any step") {
  CHECK(run_window("question-drag", R"(
wait settled
stage zero-set
next-event collapse zero-set
expect what-if.verdict == none
drag-target 0 0
expect what-if.verdict == possible and what-if.cost == xray.cost
drag-target 40 -30
expect what-if.verdict != none and what-if.cost != xray.cost
expect selection == edge
what-if found
expect what-if.cost == xray.cost
back
expect what-if.verdict != none
next-event kernel-empty zero-set
expect what-if.verdict == none
quit
)",
                   bracket) == 0);
}

TEST_CASE("which neighbouring collapse would make it possible") {
  CHECK(run_window("question-unlock", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
expect unlock.trials == none
unlock
wait settled
expect unlock.trials > 3 and unlock.possible >= unlock.count
quit
)",
                   bracket) == 0);
}

TEST_CASE("17 and the improver: what an operation changed, and how a repair went") {
  CHECK(run_window("question-17", R"(
wait settled
stage zero-set
next-event collapse zero-set
expect facets_removed > facets_added and vertices_moved >= 1
blink
wait 1
expect moment != both
blink
expect moment == both
stage improve
next-event repair improve
expect event.kind == repair and repair.sweeps >= 1
expect repair.last <= event.limit and repair.excess <= 0
next-event stays-above
expect event.kind == rejection and event.value > event.limit and repair.sweeps >= 1
expect repair.excess > 0
quit
)",
                   "gallery:bracket --size 1440x900") == 0);
}
