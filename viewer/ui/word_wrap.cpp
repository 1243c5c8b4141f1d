// Greedy lines.
#include "ui/word_wrap.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

constexpr std::array<std::string_view, 8> units{"δ", "%", "°", "ms", "s", "min", "MB", "MiB"};

/// Whether a number ends at that blank and its unit begins behind it.
bool joins_unit(std::string_view text, std::size_t blank) {
  if (blank == 0 || text[blank - 1] < '0' || text[blank - 1] > '9') return false;
  const std::string_view rest = text.substr(blank + 1);
  return std::any_of(units.begin(), units.end(), [&](std::string_view unit) {
    if (!rest.starts_with(unit)) return false;
    const char after = rest.size() > unit.size() ? rest[unit.size()] : ' ';
    return std::string_view(" .,;:)\n").find(after) != std::string_view::npos;
  });
}

std::size_t word_end(std::string_view text, std::size_t from) {
  std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
  while (end < text.size() && text[end] == ' ' && joins_unit(text, end))
    end = std::min(text.find_first_of(" \n", end + 1), text.size());
  return end;
}

} // namespace

std::size_t line_end(std::string_view text, float width, const TextWidth& wide) {
  std::size_t end = word_end(text, 0);
  while (end < text.size() && text[end] != '\n') {
    const std::size_t next = word_end(text, end + 1);
    if (wide(text.substr(0, next)) > width) break;
    end = next;
  }
  return end;
}

std::string broken_lines(std::string_view text, float width, const TextWidth& wide) {
  std::string lines;
  bool first = true;
  while (!text.empty()) {
    const std::size_t end = line_end(text, width, wide);
    if (!first) lines += '\n';
    first = false;
    lines += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

} // namespace isoscope
