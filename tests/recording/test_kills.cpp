// isoscope-run --record killed at random moments: every file opens and holds a run's beginning.
#include "input/temporary_folder.h"
#include "journal/digest.h"
#include "mesh/complex.h"
#include "recording/recording_reader.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Starts the program and kills it after so long; true when it was still running.
bool run_and_kill(const std::string& file, std::chrono::microseconds after) {
  const pid_t process = fork();
  if (process == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execl(ISOSCOPE_RUN_PROGRAM, ISOSCOPE_RUN_PROGRAM, "gallery:sphere", "--tolerance", "8%", "--record",
          file.c_str(), "--quiet", static_cast<char*>(nullptr));
    _exit(127);
  }
  std::this_thread::sleep_for(after);
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status);
}

struct Opened {
  Journal journal;
  std::string error; ///< of opening; empty when it was read
  bool ended = false;
};

void open_recording(const std::string& file, Opened& opened) {
  auto reader = RecordingReader::open(file);
  if (!reader) {
    opened.error = reader.error().message;
    CHECK(!reader.error().remedy.empty());
    return;
  }
  for (;;) {
    const auto more = (*reader)->read_commit(opened.journal);
    REQUIRE(more.ok());
    if (!*more) break;
  }
  CHECK(!(*reader)->growing());
  const auto end = (*reader)->end();
  REQUIRE(end.ok());
  opened.ended = end->has_value();
}

void kill_at_random_moments(int kills) {
  const TemporaryFolder folder;
  const std::string whole = (folder / "whole.isorun").string();
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(run_batch({"gallery:sphere", "--tolerance", "8%", "--record", whole, "--quiet"}).status == 0);
  auto takes =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  Opened complete;
  open_recording(whole, complete);
  REQUIRE(complete.ended);

  std::mt19937_64 random(4242);
  int killed = 0, with_events = 0;
  const auto too_early = [&] { takes += takes / 8; }; // the machine is busier than it was then
  for (int i = 0; i < kills; ++i) {
    const std::string file = (folder / ("killed-" + std::to_string(i) + ".isorun")).string();
    const double part = 1.05 * static_cast<double>(random() % 10000) / 10000;
    const auto after = std::chrono::duration_cast<std::chrono::microseconds>(takes * part);
    if (run_and_kill(file, after))
      ++killed;
    else
      takes = std::min(takes, after);     // the machine was busier when the whole run was timed
    if (!std::filesystem::exists(file)) { // killed before it was made
      too_early();
      continue;
    }
    Opened opened;
    open_recording(file, opened);
    CAPTURE(i);
    if (!opened.error.empty()) {
      // So early that there was no run yet: the message says so.
      CAPTURE(opened.error);
      CHECK((opened.error.find("is empty") != std::string::npos ||
             opened.error.find("before the run began") != std::string::npos));
      too_early();
      continue;
    }
    const std::size_t events = opened.journal.events().size(), steps = opened.journal.operations().size();
    if (events > 0)
      ++with_events;
    else
      too_early();
    REQUIRE(events <= complete.journal.events().size());
    Digest read, expected;
    Complex state;
    for (std::size_t k = 0; k < events; ++k) {
      read.add(opened.journal.events()[k]);
      expected.add(complete.journal.events()[k]);
    }
    for (std::size_t k = 0; k < steps; ++k) {
      read.add(opened.journal.operations()[k].delta());
      expected.add(complete.journal.operations()[k].delta());
      state.apply(opened.journal.operations()[k].delta());
    }
    CHECK(read.value() == expected.value());
    for (std::size_t k = steps; k-- > 0;) state.undo(opened.journal.operations()[k].delta());
    CHECK(digest(state) == digest(Complex()));
    if (opened.ended) CHECK(events == complete.journal.events().size());
  }
  CHECK(killed > kills / 2);
  CHECK(with_events > kills / 8);
}

} // namespace

TEST_CASE("Kills at random moments leave recordings that open") {
  kill_at_random_moments(16);
}

TEST_CASE("Sixty kills leave sixty recordings that open" * doctest::test_suite("soak")) {
  kill_at_random_moments(60);
}
