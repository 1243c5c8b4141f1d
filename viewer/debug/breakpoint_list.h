// The breakpoints tab, errors of conditions below their fields, and how lanes of saved filters are told
// apart.
#pragma once

#include "debug/debugger.h"
#include "ui/ui.h"

#include <array>
#include <string>

namespace isoscope {

/// The breakpoints with their counts, and a field for another one.
class BreakpointList {
 public:
  void draw(Ui& ui, const Debugger& debugger);

 private:
  std::array<char, 256> text_{};
};

/// What is wrong with a condition, below the field it was typed into: a caret below its place and two lines.
void query_error(Ui& ui, const QueryError& error, const std::string& text, float left);
/// The colour of a saved filter's lane; it also has a letter.
Rgb lane_color(std::size_t filter);
std::string lane_letter(std::size_t filter);

} // namespace isoscope
