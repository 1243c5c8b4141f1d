// Scripted sessions of the debugger: breakpoints, the language of the event list, lanes, ranges, steps on
// three levels.
#include "support/window_script.h"

#include <doctest/doctest.h>

using isoscope::test::run_window;

TEST_CASE("a run pauses at its breakpoints, and one goes on from hit to hit and back") {
  CHECK(run_window("breakpoints", R"(
break stage_begin && stage == gamma
break reject && stage == gamma
break collapse
expect breakpoints == 3
breakpoint 3 off
open gallery:sphere paused
wait settled
expect phase == paused
key F5
wait settled
expect phase == paused and hit.id == 1 and event.here == hit.event
expect breakpoints.hits == 1
breakpoint 1 remove
key F5
wait settled
expect phase == paused and hit.id == 2 and event.here == hit.event
expect event.kind == rejection
breakpoint 2 off
breakpoint 3 on
key F5
wait settled
expect phase == paused and hit.id == 3 and event.kind == collapse
breakpoint 3 remove
breakpoint 2 remove
expect breakpoints == 0
key F5
wait settled
expect phase == finished
quit
)",
                   "") == 0);
}

TEST_CASE("hits are counted anew for every run") {
  CHECK(run_window("another-run", R"(
break stage_begin && stage == gamma
break reject && stage == gamma
open gallery:sphere paused
wait settled
key F5
wait settled
expect phase == paused and breakpoints.hits > 0
breakpoint 2 off
open gallery:sphere paused
wait settled
expect phase == paused and breakpoints.hits == 0 and hit.event == none
key F5
wait settled
expect phase == paused and breakpoints.hits == 1 and hit.id == 1 and event.here == hit.event
breakpoint 1 remove
breakpoint 2 remove
quit
)") == 0);
}

TEST_CASE("over the journal of a finished run F5 and Shift+F5 find the same events") {
  CHECK(run_window("journal", R"(
wait settled
expect phase == finished
break stage_begin && (stage == gamma || stage == zero_set)
first
key F5
wait settled
expect state_step == begin.gamma
key F5
wait settled
expect state_step == begin.zero-set
key F5
wait settled
expect state_step == begin.zero-set
key Shift+F5
wait settled
expect state_step == begin.gamma
key Shift+F5
wait settled
expect state_step == begin.gamma
next-event collapse && value > 0
key F9
expect breakpoints == 2
key F9
expect breakpoints == 1
quit
)") == 0);
}

TEST_CASE("a wrong condition is refused") {
  CHECK(run_window("wrong", "break rejct\nquit\n") == 1);
  CHECK(run_window("wrong-filter", "filter reason == kernl\nquit\n") == 1);
}

TEST_CASE("the list takes conditions and words, saved ones are lanes, a range limits them") {
  CHECK(run_window("filters", R"(
wait settled
filter reject && reason == outside_tolerance
wait settled
expect events.listed == rejected.outside-tolerance and events.listed > 0
save-filter
filter +reject +(outside folded) -insertion
wait settled
expect events.listed > 0
filter collapse && kind != repair
wait settled
expect events.listed == count.collapse
save-filter
wait settled
expect filters == 2 and lane.events > count.collapse
range 0 10
filter insertion
wait settled
expect events.listed == 11
tab events
key Esc
wait settled
expect range.begin == none and events.listed == count.insertion
tab timeline
drag 300 760 600 760 shift
expect range.begin != none
forget-filter 1
expect filters == 1
quit
)") == 0);
}

TEST_CASE("steps over, into and out of stages, operations and gates") {
  CHECK(run_window("levels", R"(
wait settled
stage zero-set
wait settled
next-event rejection
wait settled
expect depth == 1 and gates == 11
key F11
wait settled
expect depth == 2 and gate.number == 1 and gate.failed == off
step-over 9
expect gate.number == 10
key Shift+F10
expect gate.number == 9
key Shift+F11
expect depth == 1
key F10
wait settled
expect event.kind != none
key Shift+F10
key Shift+F11
expect depth == 0
key Shift+F10
wait settled
expect state_step == begin.zero-set
key F10
wait settled
expect state_step == begin.all
key F11
expect depth == 1
next-event repair && sweeps > 1
wait settled
key F11
wait settled
expect depth == 2 and gates >= 2 and gate.number == 1
step-over 100
expect depth == 1
next-event stays_above && sweeps > 0
wait settled
key F11
wait settled
step-over
expect depth == 2
quit
)") == 0);
}
