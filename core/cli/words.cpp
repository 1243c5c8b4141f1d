// Counts with their nouns, and aligned lines.
#include "cli/words.h"

#include "base/grouped.h"

namespace isoscope {

std::string counted(std::size_t n, const std::string& noun, const std::string& plural) {
  return grouped(n) + " " + (n == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

std::string line(std::string_view label, const std::string& text) {
  constexpr std::size_t column = 13;
  std::string result(label);
  result.resize(column, ' ');
  return result + text + "\n";
}

} // namespace isoscope
