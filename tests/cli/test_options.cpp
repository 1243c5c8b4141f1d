// The command line: what is answered, what is refused, and with which exit status.
#include "input/temporary_folder.h"
#include "run/parameters.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("Questions are answered on standard output with status 0") {
  const Ended version = run_batch({"--version"});
  CHECK(version.status == 0);
  CHECK(version.out.starts_with("isoscope-run "));
  const Ended help = run_batch({"--help"});
  CHECK(help.status == 0);
  std::vector<std::string> options{
      "-o",           "--report",       "--quiet",  "--compare", "--no-condition",
      "--no-normals", "--list-gallery", "--outside"};
  for_each_field<RunParameters>([&](const auto& f) { options.push_back(f.option_name()); });
  for (const std::string& option : options) {
    CAPTURE(option);
    CHECK(help.out.find(option) != std::string::npos);
  }
  const Ended list = run_batch({"--list-gallery"});
  CHECK(list.status == 0);
  CHECK(list.out.find("gallery:torus") != std::string::npos);
  CHECK(list.error.empty());
}

TEST_CASE("Answers into a pipe that nobody reads are no failure, those onto a full disk are") {
  for (const char* question :
       {"--help", "--man", "--version", "--list-gallery", "replay --help", "diff --man", "recover --help"}) {
    CAPTURE(question);
    // The reader has gone before the first byte comes.
    const Ended piped =
        run_shell("{ sleep 0.2; \"$PROGRAM\" " + std::string(question) + "; echo $? >&2; } | true");
    CHECK(piped.error == "0\n");
    if (!std::filesystem::exists("/dev/full")) continue;
    const Ended full = run_shell("exec \"$PROGRAM\" " + std::string(question) + " > /dev/full");
    CHECK(full.status == 1);
    CHECK(full.error.find("standard output") != std::string::npos);
  }
}

TEST_CASE("Wrong usage is named on one line with status 2") {
  struct Case {
    std::vector<std::string> arguments;
    std::string named;
  };
  const std::vector<Case> cases = {
      {{}, "INPUT"},
      {{"gallery:sphere", "--tolerance", "0"}, "--tolerance"},
      {{"gallery:sphere", "--tolerance", "-1%"}, "--tolerance"},
      {{"gallery:sphere", "--tolerance", "much"}, "--tolerance"},
      {{"gallery:sphere", "--tolerance", ""}, "--tolerance"},
      {{"gallery:sphere", "-o", ""}, "--output"},
      {{"gallery:sphere", "--report", ""}, "--report"},
      {{"gallery:sphere", "--record", ""}, "--record"},
      {{"gallery:sphere", "--until", ""}, "--until"},
      {{""}, "INPUT"},
      {{"replay", ""}, "RUN"},
      {{"diff", "a.isorun", ""}, "B"},
      {{"gallery:sphere", "--sigma", "0"}, "--sigma"},
      {{"gallery:sphere", "--sigma", "2"}, "--sigma"},
      {{"gallery:sphere", "--sigma", "fine"}, "--sigma"},
      {{"gallery:sphere", "--alpha", "1"}, "--alpha"},
      {{"gallery:sphere", "--shrink", "0"}, "--shrink"},
      {{"gallery:sphere", "--threads", "-2"}, "--threads"},
      {{"gallery:sphere", "--time-limit", "-1"}, "--time-limit"},
      {{"gallery:sphere", "--containment", "both"}, "--containment"},
      {{"gallery:sphere", "--sides", "left"}, "--sides"},
      {{"gallery:sphere", "--topology", "lose"}, "--topology"},
      {{"gallery:sphere", "--no-condition", "5"}, "--no-condition"},
      {{"gallery:sphere", "--until", "sunset"}, "--until"},
      {{"gallery:sphere", "--skip", "tessellation"}, "--skip"},
      {{"gallery:sphere", "--target", "luck"}, "--target"},
      {{"gallery:sphere", "--cost-ring", "3"}, "--cost-ring"},
      {{"gallery:sphere", "--effort", "4"}, "--effort"},
      {{"gallery:sphere", "--drop-small", "-1"}, "--drop-small"},
      {{"gallery:sphere", "--improver", "outside"}, "--improver"},
      {{"gallery:sphere", "--wrong"}, "--wrong"},
      {{"gallery:sphere", "gallery:torus"}, "gallery:torus"},
  };
  for (const Case& c : cases) {
    const Ended ended = run_batch(c.arguments);
    CAPTURE(c.named);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.error.find(c.named) != std::string::npos);
  }
}

TEST_CASE("Input that is no surface is named with status 3") {
  const TemporaryFolder folder;
  const Ended missing = run_batch({(folder / "missing.off").string()});
  CHECK(missing.status == 3);
  CHECK(missing.error.find("missing.off") != std::string::npos);
  const Ended garbage = run_batch({folder.file("garbage.off", "OFF\n1 2 banana\n").string()});
  CHECK(garbage.status == 3);
  CHECK(garbage.error.find("garbage.off") != std::string::npos);
  const char* crossing =
      "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0.1 0.1 0.01\n1 0.2 0\n0.2 1 0.01\n3 0 1 2\n3 3 4 5\n";
  const Ended open = run_batch({folder.file("open.off", crossing).string(), "--tolerance", "2%"});
  CHECK(open.status == 3);
  CHECK(open.error.find("open") != std::string::npos);
  const Ended unknown = run_batch({"gallery:teapot"});
  CHECK(unknown.status == 3);
  CHECK(unknown.error.find("torus") != std::string::npos);
  for (const Ended& ended : {missing, garbage, open, unknown}) {
    CHECK(ended.out.empty());
    CHECK(std::count(ended.error.begin(), ended.error.end(), '\n') == 1);
  }
}
