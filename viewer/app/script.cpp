// Reading and running scripts.
#include "app/script.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace isoscope {

Result<std::vector<ScriptLine>> parse_script(const CommandTable& table, std::string_view text) {
  std::vector<ScriptLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    CommandCall call = table.parse(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (call.name.empty() || call.name.starts_with('#')) continue;
    if (table.find(call.name) == nullptr)
      return Error{ErrorCode::usage,
                   "Line " + std::to_string(number) + ": there is no command \"" + call.name + "\".",
                   "isoscope's F1 lists them."};
    lines.push_back({number, std::move(call)});
  }
  return lines;
}

Result<std::vector<ScriptLine>> read_script(const CommandTable& table, const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return usage("The script " + file.string() + " cannot be read.");
  auto lines = parse_script(table, std::string{std::istreambuf_iterator<char>(in), {}});
  if (lines && lines->empty())
    return Error{ErrorCode::usage, "The script " + file.string() + " has no command.",
                 "isoscope's F1 lists them."};
  return lines;
}

std::string ScriptRunner::place() const {
  if (at_ == 0) return {};
  const ScriptLine& line = lines_[at_ - 1];
  return "Line " + std::to_string(line.number) + " (" + line.call.name + "): ";
}

Status ScriptRunner::next(const CommandTable& table) {
  if (done()) return {};
  const ScriptLine& line = lines_[at_++];
  Status status = table.run(line.call);
  if (status) return status;
  Error error = status.error();
  error.message = place() + error.message;
  return error;
}

} // namespace isoscope
