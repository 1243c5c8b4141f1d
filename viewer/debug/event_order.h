// The columns of the event list: what they hold, and the order that one of them gives.
#pragma once

#include "debug/filtered_events.h"
#include "model/journal_index.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

inline constexpr std::array<std::string_view, 5> event_column_names{"step", "value", "limit", "ms",
                                                                    "element"};

/// What an event measured, in δ where it is a length; the milliseconds of an operation; what it names.
struct EventNumbers {
  std::optional<double> value, limit, milliseconds;
  std::string_view unit; ///< of value and limit
  std::uint32_t element = 0xffffffffu;
};
EventNumbers event_numbers(const Journal& journal, const JournalIndex& index, std::uint32_t event);

/// Sorted anew where journal, query or wish are others; rows that come in are merged.
class EventOrder {
 public:
  /// The rows by a column; what has nothing there comes last, equals by step. By step, and of more than
  /// `most` rows, they are as they were.
  const std::vector<std::uint32_t>& of(const FilteredEvents& listed, const JournalIndex& index,
                                       EventSort sort);
  static constexpr std::size_t most = 300000;

 private:
  std::shared_ptr<const Journal> journal_;
  EventQuery query_;
  EventSort sort_;
  std::size_t taken_ = 0;
  Step indexed_ = 0; ///< steps whose times were known
  struct Keyed {
    double key = 0; ///< NaN: nothing there
    std::uint32_t row = 0;
  };
  std::vector<Keyed> settled_; ///< the first rows of the list, those whose keys stay, in the order wanted
  std::vector<std::uint32_t> rows_;
};

} // namespace isoscope
