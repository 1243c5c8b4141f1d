// Text without regard to the case of its letters.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace isoscope {

/// The lower case of an ASCII letter; other bytes as they are.
inline char folded(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}
inline bool contains_folded(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) { return folded(a) == folded(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

} // namespace isoscope
