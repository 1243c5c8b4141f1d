// Filtering events.
#include "app/event_filter.h"

namespace isoscope {
namespace {

template <class Enum, std::size_t n> bool narrow_to(std::bitset<n>& set, const std::string& name) {
  for (std::size_t i = 0; i < n; ++i)
    if (isoscope::name(static_cast<Enum>(i)) == name) {
      if (set.all()) set.reset();
      set.set(i);
      return true;
    }
  return false;
}

} // namespace

bool EventFilter::passes(const Event& event) const {
  return stages[static_cast<std::size_t>(event.stage)] && kinds[static_cast<std::size_t>(event.kind)] &&
         conditions[static_cast<std::size_t>(event.condition)] &&
         reasons[static_cast<std::size_t>(event.reason)];
}

// "tessellation" names a stage and a kind: the stage holds both. "none" names no choice.
bool EventFilter::narrow(const std::string& name) {
  if (name == "all") {
    *this = {};
    return true;
  }
  if (name == "none") return false;
  return narrow_to<Stage>(stages, name) || narrow_to<EventKind>(kinds, name) ||
         narrow_to<Condition>(conditions, name) || narrow_to<Reason>(reasons, name);
}

} // namespace isoscope
