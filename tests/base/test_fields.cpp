// A struct of its own gets fields: it is seen in files, comparisons, keys, on the command line and in
// scripts.
#include "base/field_options.h"
#include "base/fields_json.h"
#include "cli/command_line.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace lamps {

using namespace isoscope;

enum class Colour : std::uint8_t { warm, cold };

struct Lamp {
  std::string name;
  double brightness = 0.5;
  double current = 0; ///< 0: the lamp's own
  int rings = 2;
  bool dimmed = false;
  Colour colour = Colour::warm;
  std::optional<double> timer = 10;
  std::array<bool, 3> beams{true, true, true};
  std::array<bool, 2> broken{};
  unsigned wires = 2;
  std::optional<Colour> second;
  friend bool operator==(const Lamp&, const Lamp&) = default;
};

constexpr std::array<Choice, 2> colours{
    {{.name = "warm", .told = "yellow"}, {.name = "cold", .told = "blue"}}};
constexpr std::array<Choice, 3> numbers{{{"1"}, {"2"}, {"3"}}};
constexpr std::array<Choice, 2> parts{{{"bulb"}, {"shade"}}};

constexpr auto fields_of(const Lamp*) {
  return std::tuple{
      field(&Lamp::name, {.name = "name", .option = "NAME", .symbol = "name", .help = "which lamp"}),
      field(&Lamp::brightness,
            {.name = "brightness",
             .symbol = "β",
             .unit = " lm",
             .help = "how bright",
             .words = "brightness",
             .range = {.low = 0, .high = 1, .low_included = false, .remedy = "Half is enough."},
             .restart = false}),
      field(&Lamp::current, {.name = "current",
                             .symbol = "I",
                             .help = "amperes",
                             .words = "amperes; 0 the lamp's own",
                             .range = {.low = 0, .high = 2, .low_included = false},
                             .zero_is_default = true}),
      field(&Lamp::rings, {.name = "rings",
                           .symbol = "rings",
                           .help = "rings of light",
                           .words = "rings",
                           .range = {.low = 0, .high = 3, .wrong = "no number of rings"}}),
      field(&Lamp::dimmed, {.name = "dimmed_light", .symbol = "dimmed", .help = "dim it", .words = "dimmed"}),
      field(&Lamp::colour, {.name = "colour",
                            .symbol = "colour",
                            .help = "warm or cold",
                            .words = "its colour",
                            .choices = colours}),
      field(&Lamp::timer, {.name = "timer",
                           .symbol = "timer",
                           .unit = " s",
                           .help = "seconds or off",
                           .words = "seconds or off",
                           .range = {.low = 0, .high = 100},
                           .absent = "off"}),
      field(&Lamp::beams, {.name = "beams",
                           .option = "--no-beam",
                           .symbol = "beams",
                           .help = "switch a beam off",
                           .words = "a beam",
                           .prefix = "beam-",
                           .choices = numbers,
                           .numbered = true}),
      field(&Lamp::broken, {.name = "broken",
                            .symbol = "broken",
                            .help = "a part",
                            .words = "it is broken",
                            .prefix = "broken.",
                            .choices = parts}),
      field(&Lamp::wires,
            {.name = "wires", .symbol = "wires", .help = "of copper", .journal = JournalChange::none}),
      field(&Lamp::second,
            {.name = "second",
             .symbol = "second",
             .help = "a second colour",
             .words = "a second colour, default its own",
             .choices = colours,
             .absent = "default"},
            [](const Lamp& lamp) { return std::optional(lamp.second.value_or(lamp.colour)); }),
  };
}

Lamp odd() {
  Lamp lamp;
  lamp.name = "desk";
  lamp.brightness = 0.25;
  lamp.current = 1.5;
  lamp.rings = 3;
  lamp.dimmed = true;
  lamp.colour = Colour::cold;
  lamp.timer.reset();
  lamp.beams[1] = false;
  lamp.broken[1] = true;
  lamp.wires = 5;
  lamp.second = Colour::warm;
  return lamp;
}

/// What a command line gives, or the first thing wrong with it.
Result<Lamp> parsed(std::vector<std::string> arguments) {
  Lamp lamp;
  std::optional<Error> wrong;
  CommandLine line("Lights a desk.", "lamp");
  line.fields(field_options(lamp), wrong);
  std::vector<const char*> words{"lamp"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  const auto asked = line.read(static_cast<int>(words.size()), words.data());
  if (!asked) return asked.error();
  if (wrong) return *wrong;
  return lamp;
}

} // namespace lamps

using namespace lamps;

TEST_CASE("fields are written to files and read back") {
  const std::string text = fields_json(Lamp()).dump();
  CHECK(text == R"({"name":"","brightness":0.5,"current":0.0,"rings":2,"dimmed_light":false,"colour":"warm",)"
                R"("timer":10.0,"beams":[true,true,true],"broken":[],"wires":2})");
  Lamp back;
  read_fields(fields_json(odd()), back);
  CHECK(back == odd());
  CHECK(fields_json(odd())["second"] == "warm");
  CHECK(fields_json(odd())["timer"].is_null());
  // What an older file lacks stays as it is; an optional number was not there then.
  Lamp older;
  read_fields(FieldJson::parse(R"({"rings": 1})"), older);
  CHECK(older.rings == 1);
  CHECK(older.brightness == 0.5);
  CHECK(!older.timer.has_value());
  for (const char* wrong : {"[1]", R"({"rings": 1.5})", R"({"brightness": "x"})", R"({"beams": [true]})"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(read_fields(FieldJson::parse(wrong), older), FieldJson::exception);
  }
}

TEST_CASE("fields are compared and told, and make a key") {
  CHECK(differing_fields(Lamp(), Lamp()).empty());
  const auto rows = differing_fields(Lamp(), odd());
  REQUIRE(rows.size() == 9); // wires change nothing, and the second colour is warm in both
  CHECK(rows[1] == FieldDifference{"β", "0.5 lm", "0.25 lm"});
  CHECK(rows[2] == FieldDifference{"I", "default", "1.5"});
  CHECK(rows[5] == FieldDifference{"colour", "yellow", "blue"});
  CHECK(rows[6] == FieldDifference{"timer", "10 s", "off"});
  CHECK(rows[7] == FieldDifference{"beams", "1 2 3", "1 3"});
  CHECK(rows[8] == FieldDifference{"broken", "none", "shade"});
  CHECK(fields_key(Lamp()).empty());
  Lamp wired;
  wired.wires = 9;
  CHECK(fields_key(wired).empty());
  CHECK(fields_key(odd()) ==
        "name=desk\nbrightness=0.25\ncurrent=1.5\nrings=3\ndimmed_light=on\ncolour=cold\ntimer=off\n"
        "beams=1 3\nbroken=shade\n");
  const auto restart = [](const FieldFacts& f) { return f.restart; };
  Lamp brighter;
  brighter.brightness = 1;
  CHECK(!fields_differ(Lamp(), brighter, restart));
  CHECK(fields_differ(Lamp(), brighter, [](const FieldFacts&) { return true; }));
  CHECK(fields_differ(Lamp(), odd(), restart));
}

TEST_CASE("fields are options of a command line") {
  const auto lamp =
      parsed({"desk",           "--brightness", "0.25",    "--current", "1.5",      "--rings",   "3",
              "--dimmed-light", "--colour",     "cold",    "--timer",   "off",      "--no-beam", "2",
              "--broken",       "shade",        "--wires", "5",         "--second", "warm"});
  REQUIRE(lamp.ok());
  CHECK(*lamp == odd());
  CHECK(*parsed({}) == Lamp());
  const auto said = [](std::vector<std::string> arguments) {
    const auto result = parsed(std::move(arguments));
    return result ? std::string("nothing") : result.error().line();
  };
  CHECK(said({"--brightness", "2"}) == "--brightness is 2, which is not in (0, 1]. Half is enough.");
  CHECK(said({"--current", "0"}) == "--current is 0, which is not in (0, 2].");
  CHECK(said({"--rings", "7"}) == "--rings is 7, which is no number of rings.");
  CHECK(said({"--colour", "green"}) == "--colour is 'green', which is not one of warm, cold.");
  CHECK(said({"--no-beam", "4"}) == "--no-beam is '4', which is not one of 1, 2, 3.");
}

TEST_CASE("fields are named values of scripts") {
  Lamp lamp;
  std::vector<std::string> names;
  for (const NamedField<Lamp>& f : named_fields<Lamp>()) {
    CAPTURE(f.name);
    names.push_back(f.name);
    const std::string text = f.get(lamp);
    CHECK(f.set(lamp, text).ok());
    CHECK(f.get(lamp) == text);
    CHECK(!f.set(lamp, "neither number nor word").ok());
  }
  CHECK(names == std::vector<std::string>{"brightness", "current", "rings", "dimmed-light", "colour", "timer",
                                          "beam-1", "beam-2", "beam-3", "broken.bulb", "broken.shade",
                                          "second"});
  const auto rings = named_fields<Lamp>()[2];
  CHECK(rings.set(lamp, "4").error().message == "rings is 4, which is no number of rings.");
  CHECK(rings.set(lamp, "1").ok());
  CHECK(lamp.rings == 1);
}

TEST_CASE("ranges are judged, and a field is found by its member") {
  Lamp lamp;
  CHECK(check_fields(lamp).ok());
  lamp.timer = 101;
  CHECK(check_fields(lamp).error().message == "--timer is 101, which is not in [0, 100].");
  lamp.timer = std::numeric_limits<double>::quiet_NaN();
  CHECK(!check_fields(lamp).ok());
  CHECK(field_of(&Lamp::current).name == "current");
}
