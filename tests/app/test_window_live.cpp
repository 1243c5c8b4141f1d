// A session that asks everything while the run goes on: nothing waits for the run, nothing races with it.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using isoscope::test::run_window;

namespace {

namespace fs = std::filesystem;
const fs::path results = ISOSCOPE_RESULTS;

/// δ is small, so that there is much to simplify.
const std::string slow_run = "gallery:knot --tolerance 1.5% --sigma 0.95 --paused";
/// A run that outlasts the session, which ends it.
const std::string long_run = slow_run + " --effort 3";

/// Lets the run go on from where it held: there are collapses and rejections to look at already.
const std::string begin_gamma_live = R"(
wait settled
break collapse && stage == gamma
breakpoint 1 ignore 30
key F5
wait settled
expect phase == paused and hit.id == 1
breakpoint 1 remove
hold
expect phase == running
)";

/// Ends the run; what it left is at rest.
const std::string stop_run = R"(
expect phase == running
stop
wait settled
expect phase == finished and state_step == steps
)";

} // namespace

TEST_CASE("the play head goes to and fro while the run goes on and is recorded") {
  const std::string file = (results / "live.isorun").string();
  fs::create_directories(results);
  fs::remove(file);
  std::string scrubs;
  for (const int step : {10, 700, 350, 0, 800, 5, 600})
    scrubs += "seek " + std::to_string(step) +
              "\nwait answers\nexpect state_step == " + std::to_string(step) + "\n";
  REQUIRE(run_window("scrub", "record " + file + begin_gamma_live + scrubs + R"(
back 3
wait answers
expect state_step == 597
play
hands 0.4
play
drag 300 760 900 760
hands 0.2
drag 900 760 400 760
hands 0.2
first
next-change
wait answers
expect state_step > 0
stage gamma
wait answers
expect state_step == begin.gamma
end
hands 0.4
expect recording == writing and recording.events > 1000
)" + stop_run + "expect recording.events == events\nquit\n",
                     long_run) == 0);
  CHECK(
      run_window("scrubbed",
                 "wait settled\nexpect recording == opened and phase == finished\nstage gamma\nwait settled\n"
                 "expect state_step == begin.gamma\nquit\n",
                 file) == 0);
}

TEST_CASE("edges, elements and events are asked about while the run goes on") {
  REQUIRE(run_window("ask", begin_gamma_live + R"(
hands 0.3
first
next-event reject && stage == gamma
wait answers
expect event.kind == rejection and xray.verdict != none and xray.agrees == on
what-if center
wait answers
expect what-if.verdict != none
hands 0.2
next-candidate
wait answers
unlock
wait answers
next-event collapse && stage == gamma
wait answers
expect event.kind == collapse and xray.verdict == possible and xray.agrees == on
what-if optimum
wait answers
step-into
step-over 2
step-out
previous-event reject
wait answers
expect event.kind == rejection
history
hands 0.3
seek 500
wait answers
pick-worst
history
wait answers
hands 0.2
last-change
next-violation
hands 0.2
filter reject && reason == kernel_empty
hands 0.4
save-filter
filter +reject +kernel
hands 0.2
filter
range 100 900
tab events
hands 0.2
tab plots
hands 0.2
clip-next
section
hands 0.2
split
clip-next
hands 0.3
scene
clip-next
set layer.samples off
hands 0.1
undo
hands 0.1
work
wait answers
topology
wait answers
check
wait answers
tab breakpoints
break insertion && stage == improve
hands 0.2
breakpoint 2 off
end
)" + stop_run + "quit\n",
                     long_run) == 0);
}

TEST_CASE("a run is restarted and replaced while it goes on") {
  CHECK(run_window("restarts", begin_gamma_live + R"(
first
next-event collapse && stage == gamma
wait answers
expect xray.verdict == possible
what-if optimum
wait answers
restart
hands 0.3
open gallery:sphere
hands 0.1
open gallery:torus
wait settled
expect phase == finished and certified == on
quit
)",
                   slow_run) == 0);
}

TEST_CASE("the answer about a topology is not drawn on another step's Z while the run is played") {
  CHECK(run_window("played", R"(
wait settled
stage gamma
wait answers
set topology.shown on
wait answers
speed unlimited
play
hands 0.5
wait settled
expect topology.components == 1
quit
)",
                   "gallery:torus --tolerance 3% --until all") == 0);
}
