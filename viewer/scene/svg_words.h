// Numbers and colours as vector figures write them.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace isoscope::svg {

/// Without zeros behind the point that say nothing.
inline std::string number(double value, const char* format = "%.3f") {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  std::string s = text.data();
  if (s.find('.') != std::string::npos && s.find('e') == std::string::npos) {
    while (s.back() == '0') s.pop_back();
    if (s.back() == '.') s.pop_back();
  }
  return s == "-0" ? "0" : s;
}

/// "#1a2b3c"
inline std::string hex(glm::vec3 color) {
  std::array<char, 8> text{};
  const auto byte = [](float c) { return static_cast<unsigned>(std::lround(255 * c)); };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return text.data();
}

} // namespace isoscope::svg
