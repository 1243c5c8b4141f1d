// Aligned lines.
#include "cli/words.h"

namespace isoscope {

std::string line(std::string_view label, const std::string& text) {
  constexpr std::size_t column = 13;
  std::string result(label);
  result.resize(column, ' ');
  return result + text + "\n";
}

} // namespace isoscope
