// Which events a list shows: by stage, kind, condition and reason, by a condition, by a range of steps.
#pragma once

#include "journal/event.h"
#include "query/expression.h"

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace isoscope {

/// A set bit lets an event of that kind pass; an event passes when all of its four do, and works on the loop
/// of the open rim, where one is chosen: that is for whoever gathers events to ask.
struct EventFilter {
  std::bitset<stage_count> stages = std::bitset<stage_count>().set();
  std::bitset<event_kind_count> kinds = std::bitset<event_kind_count>().set();
  std::bitset<condition_count> conditions = std::bitset<condition_count>().set();
  std::bitset<reason_count> reasons = std::bitset<reason_count>().set();

  std::optional<std::uint32_t> loop; ///< its number, or other_loops

  bool passes(const Event& event) const;
  bool everything() const {
    return stages.all() && kinds.all() && conditions.all() && reasons.all() && !loop;
  }
  friend bool operator==(const EventFilter&, const EventFilter&) = default;
};

/// Steps from `begin` to `end`, both included.
struct StepSpan {
  Step begin = 0, end = 0;
  bool holds(Step step) const { return begin <= step && step <= end; }
  friend bool operator==(const StepSpan&, const StepSpan&) = default;
};

/// The columns by which events are listed.
enum class EventColumn : std::uint8_t { step, value, limit, milliseconds, element };
struct EventSort {
  EventColumn column = EventColumn::step;
  bool descending = false;
  friend bool operator==(const EventSort&, const EventSort&) = default;
};

/// The filter of the event list: what was chosen, and a condition in the query language.
struct ListFilter {
  EventFilter chosen;
  std::string condition;
  std::shared_ptr<const Expression> expression; ///< of the condition; null lets everything pass
  /// Nothing is held back by one that cannot be read.
  void set_condition(const std::string& text);
};

} // namespace isoscope
