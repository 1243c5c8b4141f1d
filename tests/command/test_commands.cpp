// The command table is complete and free of clashes; calls and chords are read as they are written.
#include "app/app_model.h"
#include "ui/bottom_tabs.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace isoscope;

TEST_CASE("every command has a name, a title, a sentence and an action") {
  const AppModel model([] {});
  std::set<std::string_view> names;
  for (const Command& command : model.commands.all()) {
    CAPTURE(command.name);
    CHECK(!command.name.empty());
    CHECK(!command.title.empty());
    CHECK(command.help.size() > 10);
    CHECK(command.help.ends_with('.'));
    const bool runs = command.run != nullptr;
    CHECK(runs);
    CHECK(names.insert(command.name).second);
    CHECK(model.commands.find(command.name) == &command);
  }
  CHECK(names.size() > 50);
}

TEST_CASE("no two commands share a key, but for those of lessons while one is on") {
  const AppModel model([] {});
  std::map<std::string, std::string_view> owners;
  for (const Command& command : model.commands.all())
    for (const Chord& chord : command.keys) {
      CAPTURE(text(chord));
      if (command.name.starts_with("lesson-")) {
        CHECK(!command.is_enabled());
        continue;
      }
      CHECK(owners.emplace(text(chord), command.name).second);
      CHECK(model.commands.find(chord) == &command);
    }
  CHECK(owners.size() > 30);
}

TEST_CASE("keys are read as they are shown") {
  const AppModel model([] {});
  for (const Command& command : model.commands.all())
    for (const Chord& chord : command.keys) CHECK(parse_chord(text(chord)) == chord);
  CHECK(parse_chord("Ctrl+Shift+p") == Chord{'P', true, true});
  CHECK(parse_chord("nothing").key == 0);
  CHECK(parse_chord("").key == 0);
}

TEST_CASE("calls are split at blanks, quotes and JSON stay whole") {
  const AppModel model([] {});
  CHECK(model.commands.parse("  step   3 ").arguments == Arguments{"3"});
  CHECK(model.commands.parse("open \"a model.off\" paused").arguments == Arguments{"a model.off", "paused"});
  CHECK(model.commands.parse("view {\"mode\": 1}  ").arguments == Arguments{"{\"mode\": 1}"});
  CHECK(model.commands.parse("expect step == 3 and steps > 2\r").arguments ==
        Arguments{"step == 3 and steps > 2"});
  CHECK(model.commands.parse("").name.empty());
  CHECK(model.commands.parse("\"").name.empty());
}

TEST_CASE("unknown and impossible commands are refused in words") {
  AppModel model([] {});
  CHECK(model.commands.run({"no-such", {}}).error().code == ErrorCode::usage);
  CHECK(!model.commands.run({"step", {}}).ok()); // no run yet
  CHECK(!model.commands.run({"seek", {"x"}}).ok());
  CHECK(model.commands.run({"gallery", {}}).ok());
  CHECK(model.overlay == Overlay::gallery);
  CHECK(model.commands.run({"clear", {}}).ok());
  CHECK(model.overlay == Overlay::none);
  CHECK(model.commands.run({"kind-tet", {}}).ok());
  CHECK(model.selection.kinds == PickKinds::tetrahedra);
  CHECK(model.commands.run({"kind-tet", {}}).ok());
  CHECK(model.selection.kinds == PickKinds::all);
}

TEST_CASE("the usage of tab names every tab") {
  const AppModel model([] {});
  const Command* command = model.commands.find("tab");
  REQUIRE(command != nullptr);
  for (const BottomTabName& tab : bottom_tabs) {
    CAPTURE(tab.word);
    CHECK(command->usage.find(tab.word) != std::string::npos);
    AppModel window([] {});
    CHECK(window.commands.run({"tab", {tab.word}}).ok());
    CHECK(window.settings.panes.tab == static_cast<BottomTab>(&tab - bottom_tabs.data()));
  }
}

TEST_CASE("wrong arguments are answered with how the command is used") {
  const AppModel model([] {});
  const Status refused = model.commands.run({"tab", {"nothing"}});
  REQUIRE(!refused.ok());
  CHECK(refused.error().remedy == "It is used so: tab " + model.commands.find("tab")->usage);
}
