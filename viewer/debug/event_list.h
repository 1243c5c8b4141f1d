// The list of events with its filter.
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
  void row(Ui& ui, std::uint32_t index, float high);
  std::array<char, 256> text_{};
  std::string applied_; ///< the model's text that the field shows
  std::optional<QueryError> error_;
  Step scrolled_to_ = 0;
};

} // namespace isoscope
