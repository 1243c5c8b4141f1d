// The first start: marks at the parts of the window that do not come back once they are closed, and ways in.
#include "input/temporary_folder.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <string>

using isoscope::bytes_of;
using isoscope::TemporaryFolder;
using isoscope::test::exit_of;
using isoscope::test::run_window;

namespace {

/// A start without a script and with the settings of that folder. The shell knows $window; what `act` does is
/// seen in the settings, which a signal has written. It and the window have so many times their usual time.
void start(const TemporaryFolder& settings, const std::string& arguments, const std::string& act,
           int patience = 1) {
  const std::string folder = settings.path().string();
  std::ofstream(settings / "start.sh")
      << "patience=" + std::to_string(patience) + "\nexport XDG_CONFIG_HOME=" + folder + "\n" +
             ISOSCOPE_PROGRAM + " " + arguments +
             " --size 1280x800 >/dev/null 2>&1 & window=$!\nsleep $((3 * patience))\n" + act +
             "\nkill -TERM $window\nwait $window\n";
  CHECK(exit_of("bash " + folder + "/start.sh") == 4);
}

bool says(const TemporaryFolder& settings, const std::string& words) {
  return bytes_of(settings / "isoscope" / "settings.json").find(words) != std::string::npos;
}

/// Starts until the settings say so, each time with more patience: nothing outside of the window tells when
/// a loaded machine has drawn it.
bool start_until(const TemporaryFolder& settings, const std::string& arguments, const std::string& act,
                 const std::string& words) {
  for (const int patience : {1, 4, 12}) {
    start(settings, arguments, act, patience);
    if (says(settings, words)) return true;
  }
  return false;
}

bool no_hands() {
  const bool missing = exit_of("command -v xdotool >/dev/null") != 0;
  if (missing) MESSAGE("SKIPPED: xdotool is not there.");
  return missing;
}

/// Where the buttons of the three marks are.
constexpr const char* view_mark = "522 509";
constexpr const char* inspector_mark = "1012 509";
constexpr const char* timeline_mark = "543 744";

} // namespace

TEST_CASE("each mark is closed by its own button, and another model or step brings none back") {
  CHECK(run_window(
            "marks",
            std::string("wait settled\nexpect coach.closed == 7\ncoach-marks\nwait 0.2\n") +
                "expect coach.closed == 0\nclick " + view_mark + "\nexpect coach.closed == 1\nclick " +
                inspector_mark + "\nexpect coach.closed == 5\nclick " + timeline_mark +
                "\nexpect coach.closed == 7\nseek 3\nreset-layout\nopen gallery:torus\nwait settled\n" +
                "expect coach.closed == 7\n" +
                // Where a mark's button was is the scene again: a drag that begins there turns it.
                "look z\nexpect heading == 0\ndrag " + view_mark + " 600 330\nexpect heading != 0\nquit\n",
            "gallery:sphere --tolerance 12% --size 1280x800") == 0);
}

TEST_CASE("what was closed stays closed from start to start" * doctest::test_suite("xdotool")) {
  if (no_hands()) return;
  const TemporaryFolder settings;
  const std::string model = "gallery:sphere --tolerance 12%";
  const auto click = [](const char* place) {
    return std::string("xdotool mousemove ") + place +
           "; sleep $patience; xdotool mousedown 1; sleep $patience; xdotool mouseup 1; sleep $((2 * "
           "patience))\n";
  };
  CHECK(start_until(settings, model, click(view_mark), "\"coach_closed\": 1"));
  CHECK(start_until(settings, model, click(inspector_mark) + click(timeline_mark), "\"coach_closed\": 7"));
  start(settings, model, "");
  CHECK(says(settings, "\"coach_closed\": 7"));
}

TEST_CASE("the three ways in are shown once" * doctest::test_suite("xdotool")) {
  if (no_hands()) return;
  const TemporaryFolder settings;
  start(settings, "", "");
  CHECK(says(settings, "\"greeted\": false"));
  CHECK(start_until(settings, "", "xdotool mousemove 640 20 key Escape; sleep $patience\n",
                    "\"greeted\": true"));
}
