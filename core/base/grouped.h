// Whole numbers for people.
#pragma once

#include <cstddef>
#include <string>

namespace isoscope {

/// "1,234,567".
inline std::string grouped(std::size_t n) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

} // namespace isoscope
