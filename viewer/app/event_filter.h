// Which events a list shows: by stage, kind, condition and reason.
#pragma once

#include "journal/event.h"

#include <bitset>
#include <string>

namespace isoscope {

/// A set bit lets an event of that kind pass; an event passes when all of its four do.
struct EventFilter {
  std::bitset<stage_count> stages = std::bitset<stage_count>().set();
  std::bitset<event_kind_count> kinds = std::bitset<event_kind_count>().set();
  std::bitset<condition_count> conditions = std::bitset<condition_count>().set();
  std::bitset<reason_count> reasons = std::bitset<reason_count>().set();

  bool passes(const Event& event) const;
  bool everything() const { return stages.all() && kinds.all() && conditions.all() && reasons.all(); }
  /// Lets pass only what carries the name: a stage ("zero-set"), a kind ("rejection"), a condition ("height")
  /// or a reason ("kernel-empty"); "all" lets everything pass. Names of different sorts add up, so that
  /// "rejection" after "zero-set" asks for both. False on a name that there is not.
  bool narrow(const std::string& name);
  friend bool operator==(const EventFilter&, const EventFilter&) = default;
};

} // namespace isoscope
