// Recordings in the real window: written from it, opened in it, without the input file.
#include "recording/copy_reader.h"
#include "support/window_script.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using isoscope::test::exit_of;
using isoscope::test::run_window;

namespace {

namespace fs = std::filesystem;
const fs::path results = ISOSCOPE_RESULTS;

/// Writes the file with so much of its end wiped out that it is torn, but more than so many events can be
/// read; false where there is no such part.
bool write_part(const fs::path& whole, const fs::path& part, std::size_t events) {
  std::ifstream in(whole, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  constexpr std::size_t page = 4096;
  for (std::size_t end = bytes.size(); end > page; end -= page) {
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(end - page), page, '\0');
    std::ofstream(part, std::ios::binary | std::ios::trunc) << bytes;
    isoscope::Journal journal;
    isoscope::CopyReader reader(part);
    if (!reader.look(journal, isoscope::RunControl())) return false;
    if (reader.torn() && !reader.end()) return journal.events().size() > events;
  }
  return false;
}

} // namespace

TEST_CASE("a run recorded from the window opens in another one and is stepped through") {
  const std::string file = (results / "window.isorun").string();
  fs::remove(file);
  REQUIRE(run_window("record",
                     "expect recording == none\nwait settled\nrecord " + file +
                         "\nexpect recording == writing\nexpect certified == on\n"
                         "wait until recording.whole == on\nexpect recording.events > 100\nquit\n",
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

TEST_CASE("a recording of a run that began with the input itself is stepped through and asked") {
  const std::string file = (results / "input.isorun").string();
  fs::create_directories(results);
  fs::remove(file);
  REQUIRE(exit_of(std::string(ISOSCOPE_RUN_PROGRAM) +
                  " gallery:bracket --start input --effort 0 --quiet --record " + file) == 0);
  CHECK(run_window("input", R"(
wait settled
expect recording == opened and phase == finished and certified == on and form == free and start == input
first
wait answers
# There is no T: nothing is judged, which is not 0.
expect state_step == 0 and bad_samples == nan and largest_error == nan and zero_vertices == 0
expect tets == 0
step
wait answers
expect state_step == 1 and form == free and zero_vertices > 100
next-event rejection
wait answers
expect event.kind == rejection and event.value > event.limit and selection == edge
history
wait answers
expect history.rows > 0
check
wait answers
end
wait settled
expect state_step == steps and certified == on
certificate
next-slide
quit
)",
                   file) == 0);
}

TEST_CASE("a file that is no recording is told") {
  fs::create_directories(results);
  const fs::path file = results / "none.isorun";
  std::ofstream(file) << "OFF\n0 0 0\n";
  CHECK(run_window("none",
                   "open " + file.string() + "\nwait until phase == failed\nexpect messages == 1\nquit\n",
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

TEST_CASE("a copy that grows is followed, torn and late as it comes, and the place is kept") {
  const std::string there = (results / "there.isorun").string(), here = (results / "here.isorun").string();
  for (const std::string& file : {there, here, here + "-wal"}) fs::remove(file);
  // In several commits, of which a copy may have the first ones alone.
  REQUIRE(run_window(
              "there",
              "wait settled\nrecord " + there +
                  "\nstep 30\nwait settled\nwait until recording.events > 30\nstep 5\nwait settled\n"
                  "wait until recording.events > 35\nplay\nwait settled\nwait until recording.events > 100\n"
                  "quit\n",
              "gallery:sphere --tolerance 12% --paused") == 0);
  // What carries it: the head, a copy whose end has not come, and then the whole by a rename, each once the
  // window says by a picture that it has seen the one before.
  const std::string part = (results / "part.isorun").string();
  REQUIRE(write_part(there, part, 20));
  const auto seen = [&](const char* name) {
    return "until [ -f '" + (results / name).string() + "' ]; do sleep 0.05; done; ";
  };
  const auto shot = [&](const char* name) { return "screenshot " + (results / name).string() + "\n"; };
  for (const char* name : {"copy-1.png", "copy-2.png", "copy-3.png", "copy-4.png"})
    fs::remove(results / name);
  const std::string carry = seen("copy-1.png") + "head -c 3000 '" + there + "' >'" + here + "'; " +
                            seen("copy-2.png") + "cp '" + part + "' '" + here +
                            ".tmp'; touch -d '90 seconds ago' '" + here + ".tmp'; mv '" + here + ".tmp' '" +
                            here + "'; " + seen("copy-3.png") + "cp '" + there + "' '" + here +
                            ".tmp'; mv '" + here + ".tmp' '" + here + "'";
  CHECK(run_window("copy",
                   "wait until recording == awaited\nexpect recording.copied == on\n" + shot("copy-1.png") +
                       "wait until recording.bytes == 3000\nexpect recording == awaited\n"
                       "wait until recording.torn == on\n" +
                       shot("copy-2.png") +
                       "wait until recording == following and recording.events > 20\n"
                       "expect recording.age >= 90 and recording.age < 600\nexpect certified == off\n"
                       "seek 3\nwait answers\nexpect state_step == 3\n" +
                       shot("copy-3.png") +
                       "wait settled\nexpect recording == opened\nexpect certified == on\nexpect "
                       "recording.torn == off\n"
                       "expect state_step == 3\nend\nwait settled\nexpect form == free\n" +
                       shot("copy-4.png") + "quit\n",
                   here + " --follow", carry) == 0);
  // What is no recording is not followed.
  CHECK(run_window("no-copy", "quit\n", "gallery:sphere --follow") == 2);
}
