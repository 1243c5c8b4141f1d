// Where shader texts come from: embedded files, or the source folder in developer builds.
#include "gl/shader_source.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace isoscope::gl {

ShaderSource::ShaderSource(std::span<const EmbeddedFile> embedded, std::filesystem::path folder)
    : embedded_(embedded), folder_(std::move(folder)) {}

Result<std::string> ShaderSource::read(std::string_view name) const {
  if (!folder_.empty()) {
    std::ifstream file(folder_ / name);
    if (file) {
      std::ostringstream text;
      text << file.rdbuf();
      return text.str();
    }
  }
  if (const EmbeddedFile* file = find_embedded(embedded_, name)) return std::string(file->text());
  return Error{ErrorCode::device, "There is no shader file named " + std::string(name) + ".", ""};
}

Result<std::string> ShaderSource::load(std::string_view name) const {
  auto text = read(name);
  if (!text) return text;
  std::istringstream lines(*text);
  std::string result, line;
  const std::string include = "#include \"";
  while (std::getline(lines, line)) {
    if (line.rfind(include, 0) == 0) {
      const std::size_t end = line.find('"', include.size());
      auto part = load(std::string_view(line).substr(include.size(), end - include.size()));
      if (!part) return part;
      result += *part;
    } else {
      result += line;
      result += '\n';
    }
  }
  return result;
}

std::uint64_t ShaderSource::revision() const {
  if (folder_.empty()) return 0;
  std::uint64_t newest = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
    const auto time = std::filesystem::last_write_time(entry.path(), ignored).time_since_epoch().count();
    newest = std::max(newest, static_cast<std::uint64_t>(time));
  }
  return newest;
}

} // namespace isoscope::gl
