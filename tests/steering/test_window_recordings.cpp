// Recordings in the real window: written from it, opened in it, without the input file.
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using isoscope::test::run_window;

namespace {

namespace fs = std::filesystem;
const fs::path results = ISOSCOPE_RESULTS;

} // namespace

TEST_CASE("a run recorded from the window opens in another one and is stepped through") {
  const std::string file = (results / "window.isorun").string();
  fs::remove(file);
  REQUIRE(run_window("record",
                     "expect recording == none\nwait settled\nrecord " + file +
                         "\nexpect recording == writing\nexpect certified == on\nwait 1\n"
                         "expect recording.events > 100\nquit\n",
                     "gallery:sphere --tolerance 12%") == 0);
  REQUIRE(fs::exists(file));
  CHECK(run_window("opened",
                   "wait settled\nexpect recording == opened\nexpect phase == finished\n"
                   "expect model == gallery:sphere\nexpect certified == on\nexpect recording.events > 100\n"
                   "seek 3\nwait settled\nexpect state_step == 3\nexpect stage == refinement\n"
                   "back 2\nwait settled\nexpect state_step == 1\nstage improve\nwait settled\n"
                   "expect form == embedded\nend\nwait settled\nexpect form == free\nscreenshot " +
                       (results / "recording.png").string() + "\nquit\n",
                   file) == 0);
  // It is opened by command too, and its input runs anew.
  CHECK(run_window("reopened",
                   "open " + file +
                       "\nwait settled\nexpect recording == opened\nrestart\nwait settled\n"
                       "expect recording == none\nexpect certified == on\nquit\n",
                   "gallery:torus --paused") == 0);
}

TEST_CASE("a file that is no recording is told") {
  fs::create_directories(results);
  const fs::path file = results / "none.isorun";
  std::ofstream(file) << "OFF\n0 0 0\n";
  CHECK(run_window("none",
                   "open " + file.string() + "\nwait 2\nexpect phase == failed\nexpect messages == 1\nquit\n",
                   "gallery:sphere --paused") == 0);
}

TEST_CASE("a window that is closed while it works leaves a recording that opens") {
  const std::string file = (results / "closed.isorun").string();
  fs::remove(file);
  // It goes on for long when it is closed.
  CHECK(run_window("closing", "wait settled\nrecord " + file + "\nstep 50\nwait settled\nhold\nquit\n",
                   "gallery:rings --tolerance 1% --paused") == 0);
  CHECK(!fs::exists(file + "-wal"));
  CHECK(run_window("closed", "wait settled\nexpect recording == opened\nexpect steps >= 50\nquit\n", file) ==
        0);
}
