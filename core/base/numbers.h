// Numbers and switches in words, for whoever writes or reads them.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace isoscope {

/// The fewest digits that read back as the same number.
template <std::floating_point Number> std::string shortest(Number value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// So many significant digits, without trailing zeros, with an exponent where it is shorter.
inline std::string general(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// So many digits behind the point; what rounds to zero has no sign.
inline std::string fixed(double value, int digits) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  const std::string_view shown = text;
  return std::string(shown.find_first_not_of("-0.") == std::string_view::npos && shown.front() == '-'
                         ? shown.substr(1)
                         : shown);
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

/// The number that the whole text is; nothing where it is none, or not finite.
template <class Number = double> std::optional<Number> read_number(std::string_view text) {
  Number value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::floating_point<Number>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// on, true, 1, or off, false, 0.
inline std::optional<bool> read_switch(std::string_view text) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  return std::nullopt;
}

} // namespace isoscope
