// Filtering events.
#include "model/event_filter.h"

namespace isoscope {
bool EventFilter::passes(const Event& event) const {
  return stages[static_cast<std::size_t>(event.stage)] && kinds[static_cast<std::size_t>(event.kind)] &&
         conditions[static_cast<std::size_t>(event.condition)] &&
         reasons[static_cast<std::size_t>(event.reason)];
}

} // namespace isoscope
