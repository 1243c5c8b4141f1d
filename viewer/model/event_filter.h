// Which events a list shows: by stage, kind, condition and reason.
#pragma once

#include "journal/event.h"

#include <bitset>

namespace isoscope {

/// A set bit lets an event of that kind pass; an event passes when all of its four do.
struct EventFilter {
  std::bitset<stage_count> stages = std::bitset<stage_count>().set();
  std::bitset<event_kind_count> kinds = std::bitset<event_kind_count>().set();
  std::bitset<condition_count> conditions = std::bitset<condition_count>().set();
  std::bitset<reason_count> reasons = std::bitset<reason_count>().set();

  bool passes(const Event& event) const;
  bool everything() const { return stages.all() && kinds.all() && conditions.all() && reasons.all(); }
  friend bool operator==(const EventFilter&, const EventFilter&) = default;
};

} // namespace isoscope
