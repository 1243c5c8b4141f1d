// Where lines of words end: at blanks alone, so that no number is torn at its point nor from its unit.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isoscope {

/// How wide a text is.
using TextWidth = std::function<float(std::string_view)>;

/// Where the line ends that the text begins with, before a blank or a line feed or at the end of it: its
/// first word is there however wide it is.
std::size_t line_end(std::string_view text, float width, const TextWidth& wide);
/// The text with line feeds for the blanks that lines end at.
std::string broken_lines(std::string_view text, float width, const TextWidth& wide);

} // namespace isoscope
