// The tabs of events and of breakpoints, and how lanes of saved filters are told apart.
#pragma once

#include "debug/debugger.h"
#include "ui/ui.h"

#include <array>
#include <optional>
#include <string>

namespace isoscope {

/// Events that pass the filter, with a field for it.
class EventList {
 public:
  void draw(Ui& ui, const Debugger& debugger);

 private:
  void filter_field(Ui& ui);
  /// The titles of the columns: a click sorts.
  void head(Ui& ui);
  void row(Ui& ui, std::uint32_t index);
  std::array<char, 256> text_{};
  std::string applied_; ///< the model's text that the field shows
  std::optional<QueryError> error_;
  Step scrolled_to_ = 0;
};

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
