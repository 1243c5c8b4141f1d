// The one table of commands: menus, keys, palette, scripts and help are all made from it.
#pragma once

#include "app/app_model.h"

#include <span>
#include <string>
#include <string_view>
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

struct Command {
  std::string_view name;  ///< what scripts type
  std::string_view title; ///< what menus show
  std::string_view usage; ///< its arguments: "[N]"
  std::string_view help;  ///< one sentence
  std::string_view menu;  ///< "File"; empty: only palette, keys and scripts
  const char* icon = nullptr;
  std::vector<Chord> keys;
  Status (*run)(AppModel&, const Arguments&) = nullptr;
  bool (*enabled)(const AppModel&) = nullptr;
  bool (*checked)(const AppModel&) = nullptr;
  bool for_scripts = false; ///< makes sense in scripts alone: not in the palette
};

std::span<const Command> command_table();
const Command* find_command(std::string_view name);
/// The command of a key, null when there is none.
const Command* find_command(const Chord& chord);

/// A command with its arguments, as panels ask for it.
struct CommandCall {
  std::string name;
  Arguments arguments;
};

/// Splits a line at blanks; "double quotes" keep them. Commands that take a condition, `view` and `expect`
/// take the rest of the line as it is.
CommandCall parse_call(std::string_view line);
/// Runs it; fails with usage on an unknown name or wrong arguments, and with what the command itself says.
Status run_command(AppModel& model, const CommandCall& call);

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

} // namespace isoscope
