// The table of commands: menus, keys, palette, scripts and help are all made from it. Features add their
// commands, bound to what they act on.
#pragma once

#include "base/geometry.h"
#include "base/status.h"

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isoscope {

/// A key with modifiers; `key` is GLFW's code.
struct Chord {
  int key = 0;
  bool control = false, shift = false;
  friend bool operator==(const Chord&, const Chord&) = default;
};
/// "Ctrl+Shift+P"
std::string text(const Chord& chord);
/// Reads what text() writes; key 0 when it cannot be read.
Chord parse_chord(std::string_view text);

using Arguments = std::vector<std::string>;
/// The arguments as the line that was typed.
std::string joined(const Arguments& arguments, std::size_t from = 0);

struct Command {
  std::string name{};  ///< what scripts type
  std::string title{}; ///< what menus show
  std::string usage{}; ///< its arguments: "[N]"
  std::string help{};  ///< one sentence
  std::string menu{};  ///< "File"; empty: only palette, keys and scripts
  const char* icon = nullptr;
  std::vector<Chord> keys{};
  std::function<Status(const Arguments&)> run{};
  std::function<bool()> enabled{}; ///< always where there is none
  std::function<bool()> checked{}; ///< not where there is none
  bool raw = false;                ///< takes the rest of the line as it is: a condition, JSON
  bool for_scripts = false;        ///< makes sense in scripts alone: not in the palette
  int group = 0;                   ///< menus draw a line between groups; the table sets it

  bool is_enabled() const { return !enabled || enabled(); }
  bool is_checked() const { return checked && checked(); }
};

/// An action on something that outlives the table.
template <class State> auto on(State& state, Status (*action)(State&, const Arguments&)) {
  return [&state, action](const Arguments& arguments) { return action(state, arguments); };
}
/// An action without arguments that cannot fail.
template <class Action> auto does(Action action) {
  return [action](const Arguments&) {
    action();
    return Status();
  };
}
/// Changes a switch, and tells how it stands.
inline auto flips(bool& place) {
  return does([&place] { place = !place; });
}
inline auto is_on(const bool& place) {
  return [&place] { return place; };
}

/// The menus, from left to right.
inline constexpr std::array<std::string_view, 8> menu_names{"File", "Run",  "Select", "Ask",
                                                            "View", "Talk", "Window", "Help"};

/// A command with its arguments, as panels ask for it.
struct CommandCall {
  std::string name;
  Arguments arguments;
};

/// What is wrong with the arguments of a command; the table adds how it is used.
Error wrong_arguments(std::string what);
/// The same where that would not help.
inline Error usage(std::string what) {
  return {ErrorCode::usage, std::move(what), ""};
}

/// The argument at a place as a number in [low, high], where it is one.
std::optional<double> number_argument(const Arguments& a, std::size_t at, double low, double high);
std::optional<std::size_t> whole_argument(const Arguments& a, std::size_t at, std::size_t low,
                                          std::size_t high = 4000000000);
/// Two arguments, and no others, as a way on the screen.
std::optional<std::array<float, 2>> pixels_of(const Arguments& a);
/// Three arguments, and no others, as a point or a direction.
std::optional<Vec3> vector_of(const Arguments& a);
/// The first argument as a count of `things`, 1 without it.
Result<long> count_argument(const Arguments& a, const std::string& things);

class CommandTable {
 public:
  /// Several at once are a group of their own, one joins the group before it.
  void add(std::initializer_list<Command> commands);
  void begin_group() { ++group_; }
  /// In the order of menus and help.
  const std::vector<Command>& all() const { return commands_; }
  /// The menu of files ends with it.
  void move_to_end(std::string_view name);
  const Command* find(std::string_view name) const;
  /// The command of a key, of several the last that is possible now; null when there is none.
  const Command* find(const Chord& chord) const;
  /// Splits a line at blanks; "double quotes" keep them.
  CommandCall parse(std::string_view line) const;
  /// Runs it; fails with usage on an unknown name or wrong arguments, and with what the command itself says.
  Status run(const CommandCall& call) const;

 private:
  std::vector<Command> commands_;
  int group_ = 0;
};

/// Where panels put what they want done.
class CommandSink {
 public:
  void post(std::string name, Arguments arguments = {}) {
    calls_.push_back({std::move(name), std::move(arguments)});
  }
  std::vector<CommandCall> take() { return std::exchange(calls_, {}); }

 private:
  std::vector<CommandCall> calls_;
};

/// Adds them; what one leaves out of menu and `enabled` it takes from `common`.
inline void add_group(CommandTable& table, const Command& common, std::initializer_list<Command> commands) {
  table.begin_group();
  for (Command command : commands) {
    if (command.menu.empty()) command.menu = common.menu;
    if (!command.enabled) command.enabled = common.enabled;
    table.add({std::move(command)});
  }
}

/// All commands by menu, with names, arguments, keys and what they do, as Markdown.
std::string command_reference(const CommandTable& table);

} // namespace isoscope
