// What ends the window from outside: real signals, and an X server that is killed under it.
#include "input/temporary_folder.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>

using isoscope::bytes_of;
using isoscope::TemporaryFolder;
using isoscope::test::exit_of;

namespace {

/// Runs the window by hand, without a script, on an X server of its own, and recording; once the recording
/// has its first operations `act` is run, a line of the shell that knows $window and $server. The window's
/// status.
int run_and(const TemporaryFolder& folder, const std::string& act) {
  const std::string work = folder.path().string();
  std::ofstream(folder / "run.sh") << "cd " + work + R"(
mkfifo display
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp +extension GLX 3<>display >server.log 2>&1 & server=$!; disown
read -r number <>display
trap 'kill -9 $server 2>/dev/null' EXIT
env -u WAYLAND_DISPLAY DISPLAY=:$number LIBGL_ALWAYS_SOFTWARE=1 XDG_CONFIG_HOME=$PWD )" +
                                          ISOSCOPE_PROGRAM + R"( gallery:rings --tolerance 1% --theme paper \
  --record run.isorun >out 2>error & window=$!
until [[ $(stat -c %s run.isorun-wal 2>/dev/null || echo 0) -gt 600000 ]]; do
  kill -0 $window || exit 99
  sleep 0.1
done
)" + act + R"(
wait $window
)";
  return exit_of("bash " + work + "/run.sh");
}

/// Without the line that is there as well where a machine has too little time for the program to end its
/// computations within a second.
std::string without_last_word(std::string error) {
  const std::string word =
      "isoscope: A computation did not end in time and is left behind; recordings are kept.\n";
  if (const std::size_t at = error.find(word); at != std::string::npos) error.erase(at, word.size());
  return error;
}

/// Settings are saved, the recording is closed and sound, and one line says so.
void check_left(const TemporaryFolder& folder, const std::string& said) {
  CHECK(bytes_of(folder / "isoscope" / "settings.json").find("\"theme\": 2") != std::string::npos);
  CHECK(!std::filesystem::exists(folder / "run.isorun-wal"));
  const std::string replay = std::string(ISOSCOPE_RUN_PROGRAM) + " replay --quiet ";
  CHECK(exit_of(replay + (folder / "run.isorun").string()) == 4); // it ended without finishing
  const std::string error = without_last_word(bytes_of(folder / "error"));
  CAPTURE(error);
  CHECK(error.find(said) != std::string::npos);
  CHECK(error.find("run.isorun is closed") != std::string::npos);
  CHECK(std::count(error.begin(), error.end(), '\n') == 1);
}

bool no_server() {
  const bool missing = exit_of("command -v Xvfb >/dev/null") != 0;
  if (missing) MESSAGE("SKIPPED: Xvfb is not there.");
  return missing;
}

} // namespace

TEST_CASE("a signal ends the window: settings are saved and the recording is closed") {
  if (no_server()) return;
  for (const std::string name : {"TERM", "HUP", "INT"}) {
    const TemporaryFolder folder;
    CAPTURE(name);
    CHECK(run_and(folder, "kill -" + name + " $window") == 4);
    check_left(folder, "Ended by SIG" + name);
  }
}

TEST_CASE("a display that is lost ends the window: settings are saved and the recording is closed") {
  if (no_server()) return;
  const TemporaryFolder folder;
  CHECK(run_and(folder, "kill -9 $server") == 2);
  check_left(folder, "The display is lost.");
}
