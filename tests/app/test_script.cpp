// Scripts are read whole before they run, and errors name their line.
#include "app/app_model.h"
#include "app/script.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("blank lines and comments are skipped, numbers are kept") {
  const AppModel model([] {});
  const auto lines = parse_script(model.commands, "# a demo\n\nstep 2\n   \nexpect step == 2\n");
  REQUIRE(lines.ok());
  REQUIRE(lines->size() == 2);
  CHECK((*lines)[0].number == 3);
  CHECK((*lines)[0].call.name == "step");
  CHECK((*lines)[1].number == 5);
  CHECK((*lines)[1].call.arguments == Arguments{"step == 2"});
}

TEST_CASE("an unknown command is refused before anything runs") {
  const AppModel model([] {});
  const auto lines = parse_script(model.commands, "step\nstpe 2\n");
  REQUIRE(!lines.ok());
  CHECK(lines.error().message.find("Line 2") != std::string::npos);
  CHECK(lines.error().code == ErrorCode::usage);
}

TEST_CASE("a missing script is a usage error") {
  CHECK(read_script(CommandTable(), "/nonexistent/script").error().code == ErrorCode::usage);
}

TEST_CASE("lines run in order and an error names its line") {
  AppModel model([] {});
  ScriptRunner runner(*parse_script(
      model.commands, "set alpha 0.4\n\nexpect alpha == 0.4\nexpect alpha == 0.5\nset alpha 0.1\n"));
  CHECK(runner.next(model.commands).ok());
  CHECK(model.draft.alpha == doctest::Approx(0.4));
  CHECK(runner.next(model.commands).ok());
  const Status failed = runner.next(model.commands);
  REQUIRE(!failed.ok());
  CHECK(failed.error().message.find("Line 4 (expect)") != std::string::npos);
  CHECK(failed.error().message.find("0.4") != std::string::npos);
  CHECK(!runner.done());
}

TEST_CASE("a file without a command is refused") {
  const Result<std::vector<ScriptLine>> lines = read_script(CommandTable(), "/dev/null");
  REQUIRE(!lines.ok());
  CHECK(lines.error().code == ErrorCode::usage);
  CHECK(lines.error().message.find("no command") != std::string::npos);
}

TEST_CASE("an empty script is done at once") {
  CHECK(ScriptRunner(*parse_script(CommandTable(), "")).done());
}
