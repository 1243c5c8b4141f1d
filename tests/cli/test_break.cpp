// Breakpoints of the batch program: where it stops, what it leaves, what it says of a wrong condition.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;
using Json = nlohmann::json;

TEST_CASE("A run stops at the event of a breakpoint, keeps what is there and has a status of its own") {
  const TemporaryFolder folder;
  const Ended ended =
      run_batch({"gallery:torus", "--break", "genus > 5", "--break", "insertion && step == 40", "-o",
                 (folder / "z.off").string(), "--report", (folder / "z.json").string()});
  CHECK(ended.status == 5);
  CHECK(ended.error.find("breakpoint 2 (insertion && step == 40) at event ") != std::string::npos);
  CHECK(ended.error.find(", step 40: ") != std::string::npos);
  const Json report = Json::parse(bytes_of(folder / "z.json"));
  CHECK(report["end"] == "stopped");
  CHECK(report.contains("certificate"));
  CHECK(read_mesh(folder / "z.off").ok());
}

TEST_CASE("A breakpoint that never holds changes nothing") {
  const Ended with = run_batch({"gallery:sphere", "--break", "genus != expected && stage == improve"});
  CHECK(with.status == 0);
  CHECK(!with.says("breakpoint"));
}

TEST_CASE("A wrong condition is a usage error with its place") {
  const Ended ended = run_batch({"gallery:sphere", "--break", "reject && reason == kernl_empty"});
  CHECK(ended.status == 2);
  CHECK(ended.out.empty());
  CHECK(ended.error.find("No reason is called kernl-empty.") != std::string::npos);
  CHECK(ended.error.find("\n  reject && reason == kernl_empty\n                      ^\n") !=
        std::string::npos);
  CHECK(ended.error.find("Did you mean kernel-empty?") != std::string::npos);
}

TEST_CASE("A run that stops at a breakpoint says so, and its recording is kept and replays to there") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string();
  const Ended ended = run_batch({"gallery:torus", "--break", "insertion && step == 40", "--record", run});
  CHECK(ended.status == 5);
  CHECK(ended.out.find("stopped at breakpoint 1 (insertion && step == 40)") != std::string::npos);
  CHECK(!ended.says("stopped by the user"));
  const Ended read = run_batch({"replay", run});
  CHECK(read.status == 4); // it has not finished
  CHECK(read.says("stopped"));
  const Ended check = run_batch({"replay", run, "--check"});
  CHECK(check.status == 0);
  CHECK(check.says("41 operations are the same"));
}
