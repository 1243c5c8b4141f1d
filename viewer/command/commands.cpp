// Looking commands up, reading and running them.
#include "command/commands.h"

#include "base/numbers.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

constexpr std::string_view form_follows = "It is used so: "; ///< a remedy that the table completes

struct KeyName {
  int key;
  std::string_view name;
};
constexpr std::array<KeyName, 27> key_names{{{GLFW_KEY_SPACE, "Space"},     {GLFW_KEY_LEFT, "Left"},
                                             {GLFW_KEY_RIGHT, "Right"},     {GLFW_KEY_UP, "Up"},
                                             {GLFW_KEY_DOWN, "Down"},       {GLFW_KEY_HOME, "Home"},
                                             {GLFW_KEY_END, "End"},         {GLFW_KEY_ESCAPE, "Esc"},
                                             {GLFW_KEY_ENTER, "Enter"},     {GLFW_KEY_BACKSPACE, "Backspace"},
                                             {GLFW_KEY_TAB, "Tab"},         {GLFW_KEY_DELETE, "Del"},
                                             {GLFW_KEY_PAGE_UP, "PageUp"},  {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                             {GLFW_KEY_EQUAL, "+"},         {GLFW_KEY_MINUS, "-"},
                                             {GLFW_KEY_LEFT_BRACKET, "["},  {GLFW_KEY_RIGHT_BRACKET, "]"},
                                             {GLFW_KEY_COMMA, ","},         {GLFW_KEY_PERIOD, "."},
                                             {GLFW_KEY_SLASH, "/"},         {GLFW_KEY_KP_1, "Num1"},
                                             {GLFW_KEY_KP_3, "Num3"},       {GLFW_KEY_KP_5, "Num5"},
                                             {GLFW_KEY_KP_7, "Num7"},       {GLFW_KEY_KP_ADD, "Num+"},
                                             {GLFW_KEY_KP_SUBTRACT, "Num-"}}};

std::string key_text(int key) {
  for (const KeyName& k : key_names)
    if (k.key == key) return std::string(k.name);
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  return std::string(1, static_cast<char>(key));
}

} // namespace

std::string text(const Chord& chord) {
  return std::string(chord.control ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "") + key_text(chord.key);
}

Chord parse_chord(std::string_view text) {
  Chord chord;
  const auto take = [&](std::string_view prefix) {
    if (!text.starts_with(prefix) || text.size() == prefix.size()) return false;
    text.remove_prefix(prefix.size());
    return true;
  };
  chord.control = take("Ctrl+");
  chord.shift = take("Shift+");
  for (const KeyName& k : key_names)
    if (k.name == text) chord.key = k.key;
  for (int f = 1; chord.key == 0 && f <= 25; ++f)
    if (text == "F" + std::to_string(f)) chord.key = GLFW_KEY_F1 + f - 1;
  if (chord.key == 0 && text.size() == 1) {
    const char c = text[0];
    if (c >= 'A' && c <= 'Z') chord.key = c;
    if (c >= 'a' && c <= 'z') chord.key = c - 'a' + 'A';
    if (c >= '0' && c <= '9') chord.key = c;
  }
  return chord;
}

std::string joined(const Arguments& arguments, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < arguments.size(); ++i) text += (text.empty() ? "" : " ") + arguments[i];
  return text;
}

Error wrong_arguments(std::string what) {
  return {ErrorCode::usage, std::move(what), std::string(form_follows)};
}

std::optional<double> number_argument(const Arguments& a, std::size_t at, double low, double high) {
  const auto number = at < a.size() ? read_number(a[at]) : std::nullopt;
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

std::optional<std::size_t> whole_argument(const Arguments& a, std::size_t at, std::size_t low,
                                          std::size_t high) {
  const auto number = number_argument(a, at, static_cast<double>(low), static_cast<double>(high));
  if (!number || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

std::optional<std::array<float, 2>> pixels_of(const Arguments& a) {
  if (a.size() != 2) return std::nullopt;
  const auto dx = read_number(a[0]), dy = read_number(a[1]);
  if (!dx || !dy) return std::nullopt;
  return std::array{static_cast<float>(*dx), static_cast<float>(*dy)};
}

std::optional<Vec3> vector_of(const Arguments& a) {
  if (a.size() != 3) return std::nullopt;
  const auto x = read_number(a[0]), y = read_number(a[1]), z = read_number(a[2]);
  if (!x || !y || !z) return std::nullopt;
  return Vec3{*x, *y, *z};
}

Result<long> count_argument(const Arguments& a, const std::string& things) {
  if (a.empty()) return 1L;
  const auto n = whole_argument(a, 0, 1, 1000000000);
  if (!n) return wrong_arguments("\"" + a[0] + "\" is not a count of " + things + ".");
  return static_cast<long>(*n);
}

void CommandTable::add(std::initializer_list<Command> commands) {
  if (commands.size() > 1) begin_group();
  for (const Command& command : commands) {
    commands_.push_back(command);
    commands_.back().group = group_;
  }
}

void CommandTable::move_to_end(std::string_view name) {
  std::stable_partition(commands_.begin(), commands_.end(), [&](const Command& c) { return c.name != name; });
}

const Command* CommandTable::find(std::string_view name) const {
  for (const Command& command : commands_)
    if (command.name == name) return &command;
  return nullptr;
}

const Command* CommandTable::find(const Chord& chord) const {
  const Command* found = nullptr;
  for (const Command& command : commands_) {
    const bool has = std::find(command.keys.begin(), command.keys.end(), chord) != command.keys.end();
    if (has && (found == nullptr || command.is_enabled())) found = &command;
  }
  return found;
}

CommandCall CommandTable::parse(std::string_view line) const {
  CommandCall call;
  const auto skip = [&] {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t' || line.front() == '\r'))
      line.remove_prefix(1);
  };
  const auto word = [&] {
    const char quote = line.front() == '"' ? '"' : '\0';
    if (quote != '\0') line.remove_prefix(1);
    const std::size_t end =
        std::min(quote != '\0' ? line.find('"') : line.find_first_of(" \t\r"), line.size());
    std::string taken(line.substr(0, end));
    line.remove_prefix(std::min(line.size(), end + (quote != '\0' ? 1 : 0)));
    return taken;
  };
  skip();
  if (line.empty()) return call;
  call.name = word();
  skip();
  if (const Command* command = find(call.name); command != nullptr && command->raw) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    if (!line.empty()) call.arguments.emplace_back(line);
    return call;
  }
  while (!line.empty()) {
    call.arguments.push_back(word());
    skip();
  }
  return call;
}

Status CommandTable::run(const CommandCall& call) const {
  const Command* command = find(call.name);
  if (command == nullptr)
    return Error{ErrorCode::usage, "There is no command \"" + call.name + "\".", "F1 lists them."};
  if (!command->is_enabled()) return usage("\"" + command->title + "\" is not possible now.");
  Status done = command->run(call.arguments);
  if (done || done.error().remedy != form_follows) return done;
  Error error = done.error();
  error.remedy += command->name + " " + command->usage;
  return error;
}

} // namespace isoscope
