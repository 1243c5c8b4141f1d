// Scripted sessions of what the inspector offers at once: breakpoints by one click, gates and sweeps that are
// highlighted, one range for every panel, the facet that a rollback left above δ.
#include "support/window_script.h"

#include <doctest/doctest.h>

using isoscope::test::run_window;

TEST_CASE("one click breaks on what the inspector shows, on the gate too") {
  CHECK(run_window("breaks", R"(
wait settled
stage zero-set
next-event rejection outside-tolerance zero-set
expect breakpoints == 0 and breaks.suggested == 4
click 1328 62
expect breakpoints == 1
key F9
expect breakpoints == 0
break-here reject && reason == outside-tolerance
expect breakpoints == 1
key F5
wait settled
expect event.kind == rejection and event.reason == outside-tolerance
step-into
step-over 6
expect gate.number == 7 and gate.failed == on
key F9
expect breakpoints == 2
key F9
expect breakpoints == 1
step-out
pick sample 5
expect breaks.suggested == 3
clear
seek 30
expect breaks.suggested == 1
key F9
expect breakpoints == 2
quit
)",
                   "gallery:bracket --size 1440x900 --effort 0") == 0);
}

TEST_CASE("a chosen range limits events, work, heat map, stall and history, and its chip clears it") {
  CHECK(run_window("one-range", R"(
wait settled
seek 40
pick vertex 20
history
wait settled
expect history.shown == history.rows and history.rows > 0
work
wait settled
expect work.decisions > 200
range 10 19
wait settled
expect work.decisions == 10 and work.total <= 10 and stall.attempts <= 10
filter
wait settled
expect events.listed == 10
tab history
wait settled
expect history.shown <= history.rows
range 0 0
wait settled
expect history.shown < history.rows
tab timeline
click 640 663
expect range.begin == none
quit
)",
                   "gallery:bracket --size 1440x900 --effort 0") == 0);
}

TEST_CASE("sweeps of a repair can be entered; a rollback names and draws the facet that stayed above") {
  CHECK(run_window("rollback", R"(
wait settled
stage improve
next-event rejection && sweeps > 0 && reason == stays_above
expect event.reason == stays-above and event.value > event.limit
expect repair.sweeps >= 1 and repair.excess > 0
expect refused.distance > 0.5
step-into
expect depth == 2 and gate.number == 1
expect refused.distance > 0
step-over
expect gate.number == 2
step-out
stage improve
next-event rejection && !(sweeps > 0) && reason == stays_above
expect refused.distance > 0.5
quit
)",
                   "gallery:bracket --size 1440x900") == 0);
}
