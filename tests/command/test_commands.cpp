// The command table is complete and free of clashes; calls and chords are read as they are written.
#include "command/commands.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace isoscope;

TEST_CASE("every command has a name, a title, a sentence and an action") {
  std::set<std::string_view> names;
  for (const Command& command : command_table()) {
    CAPTURE(command.name);
    CHECK(!command.name.empty());
    CHECK(!command.title.empty());
    CHECK(command.help.size() > 10);
    CHECK(command.help.ends_with('.'));
    const bool runs = command.run != nullptr;
    CHECK(runs);
    CHECK(names.insert(command.name).second);
    CHECK(find_command(command.name) == &command);
  }
  CHECK(names.size() > 50);
}

TEST_CASE("no two commands share a key") {
  std::map<std::string, std::string_view> owners;
  for (const Command& command : command_table())
    for (const Chord& chord : command.keys) {
      CAPTURE(text(chord));
      CHECK(owners.emplace(text(chord), command.name).second);
      CHECK(find_command(chord) == &command);
    }
  CHECK(owners.size() > 30);
}

TEST_CASE("keys are read as they are shown") {
  for (const Command& command : command_table())
    for (const Chord& chord : command.keys) CHECK(parse_chord(text(chord)) == chord);
  CHECK(parse_chord("Ctrl+Shift+p") == Chord{'P', true, true});
  CHECK(parse_chord("nothing").key == 0);
  CHECK(parse_chord("").key == 0);
}

TEST_CASE("calls are split at blanks, quotes and JSON stay whole") {
  CHECK(parse_call("  step   3 ").arguments == Arguments{"3"});
  CHECK(parse_call("open \"a model.off\" paused").arguments == Arguments{"a model.off", "paused"});
  CHECK(parse_call("view {\"mode\": 1}  ").arguments == Arguments{"{\"mode\": 1}"});
  CHECK(parse_call("expect step == 3 and steps > 2\r").arguments == Arguments{"step == 3 and steps > 2"});
  CHECK(parse_call("").name.empty());
  CHECK(parse_call("\"").name.empty());
}

TEST_CASE("unknown and impossible commands are refused in words") {
  AppModel model([] {});
  CHECK(run_command(model, {"no-such", {}}).error().code == ErrorCode::usage);
  CHECK(!run_command(model, {"step", {}}).ok()); // no run yet
  CHECK(!run_command(model, {"seek", {"x"}}).ok());
  CHECK(run_command(model, {"gallery", {}}).ok());
  CHECK(model.overlay == Overlay::gallery);
  CHECK(run_command(model, {"clear", {}}).ok());
  CHECK(model.overlay == Overlay::none);
  CHECK(run_command(model, {"kind-tet", {}}).ok());
  CHECK(model.selection.kinds == 2);
  CHECK(run_command(model, {"kind-tet", {}}).ok());
  CHECK(model.selection.kinds == 15);
}
