// The events of a growing journal that pass a filter, gathered a little at a time.
#pragma once

#include "debug/loop_events.h"
#include "model/event_filter.h"
#include "query/watch.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// What passes: all have to agree.
struct EventQuery {
  std::shared_ptr<const Expression> expression; ///< null: everything
  EventFilter chosen;
  std::optional<StepSpan> range;     ///< by Event::step
  const LoopEvents* loops = nullptr; ///< who knows the events of a chosen loop; outlives the query
  friend bool operator==(const EventQuery&, const EventQuery&) = default;
};

class FilteredEvents {
 public:
  /// Takes in at most `budget` further events; begins anew where the journal or the query is another. True
  /// when something came.
  bool update(const std::shared_ptr<const Journal>& journal, const EventQuery& query,
              std::size_t budget = 50000);
  /// Whether every complete event of the journal has been judged.
  bool complete() const;
  const std::shared_ptr<const Journal>& journal() const { return journal_; }
  const EventQuery& query() const { return query_; }
  /// Indices of events, ascending, and their steps beside them.
  const std::vector<std::uint32_t>& rows() const { return rows_; }
  /// How many while the step was in [begin, end).
  std::uint32_t count(Step begin, Step end) const;

 private:
  std::shared_ptr<const Journal> journal_;
  EventQuery query_;
  std::unique_ptr<JournalWatch> watch_;
  std::uint32_t scanned_ = 0;
  std::vector<std::uint32_t> rows_;
  std::vector<Step> steps_;
};

} // namespace isoscope
