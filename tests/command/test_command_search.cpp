// The palette finds commands by a few letters, and the manual's page is the table's.
#include "app/palette_entries.h"
#include "command/command_search.h"
#include "command/commands.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace isoscope;

namespace {

const AppModel& model() {
  static const AppModel model([] {});
  return model;
}

std::vector<const Command*> search(std::string_view typed) {
  return search_commands(model().commands, typed);
}

std::string first(std::string_view typed) {
  const auto found = search(typed);
  return found.empty() ? "" : found.front()->name;
}

bool finds(std::string_view typed, std::string_view name) {
  const auto found = search(typed);
  return std::any_of(found.begin(), found.end(), [&](const Command* c) { return c->name == name; });
}

} // namespace

TEST_CASE("letters in order match; runs and beginnings of words count more") {
  CHECK(!fuzzy_score("xyz", "Screenshot"));
  CHECK(!fuzzy_score("tohs", "shot"));
  CHECK(fuzzy_score("scr", "Screenshot"));
  CHECK(*fuzzy_score("ns", "Next slide") > *fuzzy_score("ns", "Screenshot"));
  CHECK(*fuzzy_score("slide", "Next slide") > *fuzzy_score("slide", "Set a line, divide"));
  CHECK(*fuzzy_score("SHOT", "screenshot") == *fuzzy_score("shot", "Screenshot"));
  CHECK(!fuzzy_score("aa", "a"));
}

TEST_CASE("commands are found by abbreviation, title, name and help") {
  CHECK(first("scrn") == "screenshot");
  CHECK(first("pres") == "presenter");
  CHECK(first("seek 120") == "seek");
  CHECK(first("next slide") == "next-slide");
  CHECK(first("bookmark-go 2") == "bookmark-go");
  CHECK(first("undo") == "undo");
  CHECK(finds("never of the run", "undo"));
  CHECK(search("qqqq").empty());
  CHECK(search("").size() > 50);
  CHECK(search("  ").size() == search("").size());
}

TEST_CASE("every command is first when its name is typed, and those for scripts are not offered") {
  for (const Command& command : model().commands.all()) {
    CAPTURE(command.name);
    if (command.for_scripts)
      CHECK(!finds(command.name, command.name));
    else
      CHECK(first(command.name) == command.name);
  }
}

TEST_CASE("the manual's page of commands is the one made from the table") {
  const std::string page = command_reference(model().commands);
  for (const Command& command : model().commands.all()) {
    CAPTURE(command.name);
    CHECK(page.find("| `" + command.name) != std::string::npos);
    for (const Chord& chord : command.keys) CHECK(page.find(text(chord)) != std::string::npos);
  }
  if (std::getenv("ISOSCOPE_UPDATE_REFERENCES") != nullptr) std::ofstream(ISOSCOPE_COMMANDS_PAGE) << page;
  std::ifstream in(ISOSCOPE_COMMANDS_PAGE);
  const std::string stored{std::istreambuf_iterator<char>(in), {}};
  // Made anew with ISOSCOPE_UPDATE_REFERENCES=1.
  CHECK(stored == page);
}

TEST_CASE("the palette also finds settings, lessons, models, events and elements by the words on screen") {
  const auto calls = [](const std::string& typed) {
    std::vector<std::string> lines;
    for (const PaletteEntry& entry : palette_entries(model(), typed))
      lines.push_back(joined([&] {
        Arguments line{entry.call.name};
        line.insert(line.end(), entry.call.arguments.begin(), entry.call.arguments.end());
        return line;
      }()));
    return lines;
  };
  const auto finds = [&](const std::string& typed, const std::string& line) {
    const auto all = calls(typed);
    return std::find(all.begin(), all.end(), line) != all.end();
  };
  CHECK(finds("frame", "frame-all"));
  CHECK(finds("legend of the scene", "set legend on"));
  CHECK(finds("axes drawn", "set axes off"));
  CHECK(finds("kernel", "lesson kernel"));
  CHECK(finds("vertex 12", "pick vertex 12"));
  CHECK(finds("edge 3 7", "pick edge 3 7"));
  CHECK(finds("0", "seek 0"));
  CHECK(finds("seek 120", "seek 120"));
  for (const PaletteEntry& entry : palette_entries(model(), "size of samples"))
    if (entry.call.name == "set") CHECK(entry.complete == "set sample-size ");
}
