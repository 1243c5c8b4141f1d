// Values, expectations, waiting, mouse and keys, times.
#include "app/app_model.h"
#include "ui/words_on_screen.h"

#include <array>
#include <cstdio>
#include <fstream>

namespace isoscope {
namespace {

/// The first `count` arguments as numbers.
Result<std::vector<float>> numbers(const Arguments& a, std::size_t count) {
  if (a.size() < count) return wrong_arguments("Numbers are missing.");
  std::vector<float> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = read_number(a[i]);
    if (!n) return wrong_arguments("\"" + a[i] + "\" is not a finite number.");
    out.push_back(static_cast<float>(*n));
  }
  return out;
}

bool has(const Arguments& a, std::string_view word) {
  for (const std::string& entry : a)
    if (entry == word) return true;
  return false;
}

Status set_value(AppModel& m, const Arguments& a) {
  if (a.size() != 2) return wrong_arguments("A name and a value are needed.");
  const NamedValue* value = m.values.find(a[0]);
  if (value == nullptr) return wrong_arguments("There is no value \"" + a[0] + "\".");
  if (!value->set) return wrong_arguments("\"" + a[0] + "\" can only be read.");
  return value->set(a[1]);
}

Status expect_value(AppModel& m, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("A comparison is missing.");
  return m.values.expect(a[0]);
}

Status wait_for(AppModel& m, const Arguments& a) {
  if (a.empty() || a[0] == "settled") {
    m.wait_for = AppModel::Wait::settled;
    return {};
  }
  if (a[0] == "answers") {
    m.wait_for = AppModel::Wait::answers;
    return {};
  }
  if (a[0] == "until") {
    std::size_t end = a.size();
    double patience = AppModel::usual_patience;
    if (end > 2 && a[end - 2] == "within") {
      const auto seconds = number_argument(a, end - 1, 0, 1e9);
      if (!seconds) return wrong_arguments("\"" + a[end - 1] + "\" is no time.");
      patience = *seconds;
      end -= 2;
    }
    std::string comparison;
    for (std::size_t i = 1; i < end; ++i) comparison += (i > 1 ? " " : "") + a[i];
    if (const Status holds = m.values.expect(comparison); !holds && holds.error().code == ErrorCode::usage)
      return holds;
    m.wait_for = AppModel::Wait::comparison;
    m.wait_comparison = comparison;
    m.wait_patience = patience;
    return {};
  }
  const auto seconds = number_argument(a, 0, 0, 1e9);
  if (!seconds) return wrong_arguments("\"" + a[0] + "\" is no time.");
  m.wait_until = m.clock + *seconds;
  return {};
}

Status move_mouse(AppModel& m, const Arguments& a) {
  const auto n = numbers(a, 2);
  if (!n) return n.error();
  // Two frames: the interface knows what is hovered one frame late.
  for (int i = 0; i < 2; ++i) m.requests.mouse.push_back({(*n)[0], (*n)[1]});
  return {};
}

/// Of the frame that was drawn last.
std::vector<SeenWords> seen_words() {
  const ImDrawData* frame = ImGui::GetDrawData();
  return frame != nullptr ? words_on_screen(*frame, *ImGui::GetIO().Fonts) : std::vector<SeenWords>{};
}

void press(AppModel& m, float x, float y, int button, bool control) {
  auto& mouse = m.requests.mouse;
  const auto add = [&](int pressed, bool down) { mouse.push_back({x, y, pressed, down, 0, false, control}); };
  add(-1, false);
  add(-1, false);
  add(button, true);
  add(button, false);
  add(-1, false);
}

Status click(AppModel& m, const Arguments& a) {
  const auto n = numbers(a, 2);
  if (!n) return n.error();
  press(m, (*n)[0], (*n)[1], has(a, "right") ? 1 : 0, has(a, "control"));
  return {};
}

Error not_in_sight(const std::string& words) {
  return {ErrorCode::cancelled, "\"" + words + "\" cannot be read in the window.", ""};
}

/// The mouse over the words that are asked for.
Result<MouseStep> place_of_words(const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("Which words?");
  const std::vector<SeenWords> seen = seen_words();
  const SeenWords* found = find_words(seen, a[0]);
  if (found == nullptr) return not_in_sight(a[0]);
  return MouseStep{(found->low.x + found->high.x) / 2, (found->low.y + found->high.y) / 2};
}

Status click_words(AppModel& m, const Arguments& a) {
  const auto at = place_of_words(a);
  if (!at) return at.error();
  press(m, at->x, at->y, 0, false);
  return {};
}

Status hover_words(AppModel& m, const Arguments& a) {
  const auto at = place_of_words(a);
  if (!at) return at.error();
  constexpr int frames = 40; // of a sixtieth of a second: what is said there comes after a while
  for (int i = 0; i < frames; ++i) m.requests.mouse.push_back(*at);
  return {};
}

Status drag(AppModel& m, const Arguments& a) {
  const auto n = numbers(a, 4);
  if (!n) return n.error();
  const auto& p = *n;
  const int button = has(a, "right") ? 1 : 0;
  const bool shift = has(a, "shift");
  auto& mouse = m.requests.mouse;
  const auto add = [&](float t, bool down) {
    mouse.push_back({p[0] + t * (p[2] - p[0]), p[1] + t * (p[3] - p[1]), button, down, 0, shift, false});
  };
  add(0, false);
  add(0, false);
  constexpr int moves = 8;
  for (int i = 0; i <= moves; ++i) add(static_cast<float>(i) / moves, true);
  add(1, false);
  return {};
}

Status wheel(AppModel& m, const Arguments& a) {
  const auto n = numbers(a, 3);
  if (!n) return n.error();
  auto& mouse = m.requests.mouse;
  mouse.push_back({(*n)[0], (*n)[1]});
  mouse.push_back({(*n)[0], (*n)[1]});
  mouse.push_back({(*n)[0], (*n)[1], -1, false, (*n)[2]});
  return {};
}

Status give_hands(AppModel& m, const Arguments& a) {
  const auto n = numbers(a, 1);
  if (!n) return n.error();
  m.requests.hands = static_cast<double>((*n)[0]);
  return {};
}

Status press_key(AppModel& m, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("Which key?");
  const Chord chord = parse_chord(a[0]);
  const Command* command = chord.key != 0 ? m.commands.find(chord) : nullptr;
  if (command == nullptr) return wrong_arguments("The key \"" + a[0] + "\" does nothing.");
  return m.commands.run({command->name, {}});
}

Status tell_times(AppModel& m, const Arguments& a) {
  if (a.size() == 1 && a[0] == "reset") {
    m.times.begin();
    return {};
  }
  if (!a.empty()) return Error{ErrorCode::usage, "times takes reset or nothing.", "Usage: times [reset]"};
  std::fputs(m.times.table().c_str(), stdout);
  std::fflush(stdout);
  return {};
}

Status expect_words(AppModel&, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("Which words?");
  if (can_be_read(seen_words(), a[0])) return {};
  return not_in_sight(a[0]);
}

Status expect_no_words(AppModel&, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("Which words?");
  if (!can_be_read(seen_words(), a[0])) return {};
  return Error{ErrorCode::cancelled, "\"" + a[0] + "\" can be read in the window.", ""};
}

Status tell_words(AppModel&, const Arguments& a) {
  std::string lines;
  for (const SeenWords& w : seen_words()) {
    std::array<char, 80> place{};
    std::snprintf(place.data(), place.size(), "%.0f %.0f %.0f %.0f\t%s\t", static_cast<double>(w.low.x),
                  static_cast<double>(w.low.y), static_cast<double>(w.high.x), static_cast<double>(w.high.y),
                  w.cut ? "cut" : "whole");
    lines += place.data() + w.surface + '\t' + w.text + '\n';
  }
  if (a.empty()) {
    std::fputs(lines.c_str(), stdout);
    std::fflush(stdout);
    return {};
  }
  std::ofstream out(a[0]);
  if (!(out << lines).flush())
    return Error{ErrorCode::io, a[0] + " cannot be written.", "Choose a folder that can be written to."};
  return {};
}

} // namespace

void add_script_commands(AppModel& m) {
  CommandTable& table = m.commands;
  table.add({{.name = "set",
              .title = "Set a value",
              .usage = "NAME VALUE",
              .help = "Sets a named value; parameters take effect with apply or restart.",
              .run = on(m, set_value)},
             {.name = "expect",
              .title = "Expect",
              .usage = "NAME OP VALUE [and ...]",
              .help = "Stops the script unless the comparison holds.",
              .run = on(m, expect_value),
              .raw = true,
              .for_scripts = true},
             {.name = "expect-words",
              .title = "Expect words",
              .usage = "WORDS",
              .help = "Stops the script unless these words can be read in the window; blanks do not count.",
              .run = on(m, expect_words),
              .raw = true,
              .for_scripts = true},
             {.name = "expect-no-words",
              .title = "Expect no such words",
              .usage = "WORDS",
              .help = "Stops the script where they can be read.",
              .run = on(m, expect_no_words),
              .raw = true,
              .for_scripts = true},
             {.name = "words",
              .title = "Words of the window",
              .usage = "[FILE]",
              .help = "Tells or writes what can be read in the window, a line each: its place, whether it is "
                      "cut by its pane's end, the pane, the words.",
              .run = on(m, tell_words),
              .for_scripts = true},
             {.name = "wait",
              .title = "Wait",
              .usage = "[settled | answers | SECONDS | until NAME OP VALUE [within SECONDS]]",
              .help = "Waits until the run is at rest and shown, until what was asked is answered, for a "
                      "time, or until a comparison holds; where it does not within 600 seconds of real "
                      "time, or those told, the script fails as one whose expectation does.",
              .run = on(m, wait_for),
              .for_scripts = true},
             {.name = "click",
              .title = "Click",
              .usage = "X Y [left | right] [control]",
              .help = "Clicks at a place of the window.",
              .run = on(m, click),
              .for_scripts = true},
             {.name = "click-words",
              .title = "Click on words",
              .usage = "WORDS",
              .help = "Clicks where these words stand in one line of the window.",
              .run = on(m, click_words),
              .raw = true,
              .for_scripts = true},
             {.name = "hover-words",
              .title = "Rest on words",
              .usage = "WORDS",
              .help = "Rests the mouse where these words stand in one line of the window, until what is said "
                      "there is shown.",
              .run = on(m, hover_words),
              .raw = true,
              .for_scripts = true},
             {.name = "drag",
              .title = "Drag",
              .usage = "X1 Y1 X2 Y2 [left | right] [shift]",
              .help = "Drags from one place of the window to another.",
              .run = on(m, drag),
              .for_scripts = true},
             {.name = "move",
              .title = "Move",
              .usage = "X Y",
              .help = "Moves the mouse to a place of the window.",
              .run = on(m, move_mouse),
              .for_scripts = true},
             {.name = "wheel",
              .title = "Wheel",
              .usage = "X Y STEPS",
              .help = "Turns the wheel at a place of the window.",
              .run = on(m, wheel),
              .for_scripts = true},
             {.name = "key",
              .title = "Key",
              .usage = "CHORD",
              .help = "Does what a key does: Ctrl+P, Right, F1.",
              .run = on(m, press_key),
              .for_scripts = true},
             {.name = "hands",
              .title = "Hands",
              .usage = "SECONDS",
              .help = "Lets the real mouse and keys act for a time.",
              .run = on(m, give_hands),
              .for_scripts = true},
             {.name = "dismiss",
              .title = "Dismiss",
              .help = "Removes all messages.",
              .run = does([&m] { m.messages.clear(); }),
              .for_scripts = true},
             {.name = "times",
              .title = "Times of the window",
              .usage = "[reset]",
              .help = "Prints how long frames took, and steps until their picture was there; reset begins.",
              .run = on(m, tell_times),
              .for_scripts = true}});
}

void add_time_values(AppModel& m) {
  NamedValues& t = m.values;
  const auto add = [&](const std::string& name, const std::string& what,
                       const Quantiles& (WindowTimes::*times)() const) {
    t.add(name + ".count", what + ", since times reset", [times, &m] { return (m.times.*times)().size(); });
    for (const auto& [part, word] : {std::pair{0.5, ".median"}, {0.95, ".95"}, {1.0, ".largest"}})
      t.add(name + word, "milliseconds of real time",
            [times, part = part, &m] { return 1e3 * (m.times.*times)().at(part); });
  };
  add("frame", "frames made", &WindowTimes::frames);
  add("picture", "steps whose picture appeared", &WindowTimes::pictures);
}

} // namespace isoscope
