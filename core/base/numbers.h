// Numbers in words, for whoever writes them.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>

namespace isoscope {

/// The fewest digits that read back as the same number.
inline std::string shortest(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// So many significant digits, without trailing zeros, with an exponent where it is shorter.
inline std::string general(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// "1,234,567".
inline std::string grouped(std::size_t n) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

/// "1,204 events", "1 event"; `plural` where it is not the noun with an s.
inline std::string counted(std::size_t n, const std::string& noun, const std::string& plural = {}) {
  return grouped(n) + " " + (n == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

} // namespace isoscope
