// Interrupts and limits: a run that is told to stop leaves what it has, with status 4.
#include "cli/summary.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>

using namespace isoscope;
using namespace isoscope::test;
using Json = nlohmann::json;

TEST_CASE("An interrupt during the refinement ends it cleanly and writes what is there" *
          doctest::test_suite("terminal")) {
  if (!TerminalRun::possible()) return;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    TerminalRun run({"gallery:rings", "--tolerance", "1.5%", "-o", (folder / "z.off").string(), "--report",
                     (folder / "z.json").string()});
    REQUIRE(run.read_until("refinement"));
    run.signal(signal);
    CHECK(run.finish().status == 4);
    CHECK(read_mesh(folder / "z.off").ok());
    const Json report = Json::parse(bytes_of(folder / "z.json"));
    CHECK(report["end"] == "stopped");
    CHECK(report.contains("certificate"));
  }
}

TEST_CASE("A terminal that is closed ends the run cleanly, although both shell and system tell it" *
          doctest::test_suite("terminal")) {
  if (!TerminalRun::possible()) return;
  const TemporaryFolder folder;
  TerminalRun run({"gallery:rings", "--tolerance", "1.5%", "-o", (folder / "z.off").string()});
  REQUIRE(run.read_until("refinement"));
  run.signal(SIGHUP);
  run.signal(SIGHUP);
  const Ended ended = run.hang_up();
  CHECK(ended.status == 4);
  CHECK(read_mesh(folder / "z.off").ok());
}

TEST_CASE("Under nohup a closed terminal ends nothing") {
  const Ended ended = run_shell("trap '' HUP; \"$PROGRAM\" gallery:sphere --tolerance 12% --quiet & "
                                "kill -HUP $!; wait $!");
  CHECK(ended.status == 0);
}

TEST_CASE("An interrupt before the refinement ends the program without a mesh" *
          doctest::test_suite("terminal")) {
  if (!TerminalRun::possible()) return;
  const TemporaryFolder folder;
  TerminalRun run({"gallery:rings", "--tolerance", "0.3%", "-o", (folder / "z.off").string()});
  REQUIRE(run.read_until("s")); // some part has begun
  run.signal(SIGINT);
  const Ended ended = run.finish();
  CHECK(ended.status == 4);
  CHECK(ended.says("stopped"));
  CHECK(!std::filesystem::exists(folder / "z.off"));
}

TEST_CASE("A second interrupt ends the program at once" * doctest::test_suite("terminal")) {
  if (!TerminalRun::possible()) return;
  TerminalRun run({"gallery:rings", "--tolerance", "0.5%"});
  REQUIRE(run.read_until("s"));
  run.signal(SIGINT);
  run.signal(SIGINT);
  CHECK(run.finish().status == 4);
}

TEST_CASE("A time limit ends a run with status 4") {
  const Ended ended = run_batch({"gallery:rings", "--tolerance", "0.3%", "--time-limit", "0.05"});
  CHECK(ended.status == 4);
  CHECK(ended.says("time limit"));
}

TEST_CASE("What a limit or a hand stopped is among the warnings, unless that is told already") {
  const Scene scene;
  RunResult result;
  CHECK(warnings({}, scene, result).front() == "The certificate does NOT hold.");
  result.end = RunResult::End::limit;
  CHECK(warnings({}, scene, result).front().find("stopped by a limit") != std::string::npos);
  CHECK(warnings({}, scene, result, true).front() == "The certificate does NOT hold.");
  result.end = RunResult::End::stopped;
  CHECK(warnings({}, scene, result).front().find("stopped by the user") != std::string::npos);
}

TEST_CASE("A terminal sees one line a part, rewritten in place" * doctest::test_suite("terminal")) {
  if (!TerminalRun::possible()) return;
  TerminalRun run({"gallery:sphere"});
  const Ended ended = run.finish();
  CHECK(ended.status == 0);
  CHECK(ended.says("\r"));
  CHECK(ended.says("operations"));
  CHECK(ended.says("Z "));
  CHECK(ended.says("/s"));
}
