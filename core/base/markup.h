// Plain text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace isoscope {

/// The text as it stands in elements and attributes, without control characters.
inline std::string escaped_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

} // namespace isoscope
