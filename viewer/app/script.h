// Scripts: one command a line, each run when the one before is done and shown.
#pragma once

#include "command/commands.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isoscope {

/// A script's line with its number, from 1.
struct ScriptLine {
  std::size_t number = 0;
  CommandCall call;
};

/// Reads a script; blank lines and those that begin with # are skipped. Fails with usage on an unknown
/// command, naming the line, so that nothing has run then.
Result<std::vector<ScriptLine>> parse_script(const CommandTable& table, std::string_view text);
/// The same for a file; one without a command is refused, since nothing would ever end the program.
Result<std::vector<ScriptLine>> read_script(const CommandTable& table, const std::filesystem::path& file);

/// Runs a script, a line whenever asked.
class ScriptRunner {
 public:
  explicit ScriptRunner(std::vector<ScriptLine> lines) : lines_(std::move(lines)) {}
  bool done() const { return at_ >= lines_.size(); }
  /// Whether the next line is that command.
  bool next_is(std::string_view name) const { return !done() && lines_[at_].call.name == name; }
  /// Whether it changes nothing.
  bool next_only_asks() const { return !done() && lines_[at_].call.name.starts_with("expect"); }
  /// The line that ran last, "Line 3 (wait): "; before the first nothing.
  std::string place() const;
  /// Runs the next line; the error names its number.
  Status next(const CommandTable& table);

 private:
  std::vector<ScriptLine> lines_;
  std::size_t at_ = 0;
};

} // namespace isoscope
