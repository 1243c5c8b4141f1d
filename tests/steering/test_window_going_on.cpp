// A finished run goes on improving in the window: watched, held, stepped, stopped, recorded, and told so.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using isoscope::test::run_window;

namespace {

namespace fs = std::filesystem;
const fs::path going_on_results = ISOSCOPE_RESULTS;

} // namespace

TEST_CASE(
    "a run goes on improving after its end, is held, stepped and stopped, and its recording has it all") {
  fs::create_directories(going_on_results);
  const std::string file = (going_on_results / "going-on.isorun").string();
  fs::remove(file);
  REQUIRE(run_window("going-on",
                     "expect improvable == off\nwait settled\nexpect certified == on and improvable == on\n"
                     "expect optimum > 4\nrecord " +
                         file + R"(
tab plots
set plots.over seconds
break shake
go-on-improving
wait settled
expect phase == paused and improving == on and improvable == off
breakpoint 1 remove
step 3
wait settled
expect phase == paused and state_step == steps
back 3
wait settled
first
wait settled
expect state_step == 0
end
play
hands 0.3
expect phase == running and improving == on
stop
wait settled
expect phase == finished and certified == on and improvable == on and improving == off
expect state_step == steps
screenshot )" + (going_on_results / "going-on.png").string() +
                         "\nwait until recording.whole == on\nquit\n",
                     "gallery:sphere --tolerance 4% --effort 1 --size 1280x800") == 0);
  CHECK(run_window("going-on-opened",
                   "wait settled\nexpect recording == opened and phase == finished and certified == on\n"
                   "expect improvable == off\nend\nwait settled\nexpect form == free\nquit\n",
                   file) == 0);
}

TEST_CASE("a run that ends before the improver does not offer it") {
  CHECK(run_window("not-going-on", "wait settled\nexpect improvable == off and improving == off\nquit\n",
                   "gallery:sphere --tolerance 8% --until zero-set") == 0);
}
