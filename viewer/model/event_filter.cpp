// Filtering events.
#include "model/event_filter.h"

namespace isoscope {

bool EventFilter::passes(const Event& event) const {
  return stages[static_cast<std::size_t>(event.stage)] && kinds[static_cast<std::size_t>(event.kind)] &&
         conditions[static_cast<std::size_t>(event.condition)] &&
         reasons[static_cast<std::size_t>(event.reason)];
}

void ListFilter::set_condition(const std::string& text) {
  condition = text;
  const ParsedQuery parsed = parse_query(text);
  const auto* read = std::get_if<std::shared_ptr<const Expression>>(&parsed);
  expression = read != nullptr && !text.empty() ? *read : nullptr;
}

} // namespace isoscope
