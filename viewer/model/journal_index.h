// Figures of a growing journal in plain arrays, for the timeline, the plots and jumps; taken in a little at a
// time.
#pragma once

#include "journal/journal.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace isoscope {

/// What the plots draw, one value an operation.
enum class Figure : std::uint8_t {
  bad_samples,
  largest_error,
  zero_set_vertices,
  smallest_height,
  tets,
  seconds
};
constexpr int figure_count = 6;

class JournalIndex {
 public:
  /// A stretch of steps in one stage.
  struct StageSpan {
    Stage stage = Stage::refinement;
    Step begin = 0, end = 0;
    bool open = true;
  };
  /// A step worth a mark on the timeline: parameters changed, a warning, a topology check.
  struct Mark {
    Step step = 0;
    std::uint32_t event = 0;
    EventKind kind = EventKind::warning;
  };

  /// Starts anew for another journal.
  void reset(std::shared_ptr<const Journal> journal);
  /// Takes in at most `budget` new events and operations; true when something came.
  bool update(std::size_t budget = 20000);
  bool complete() const;

  const std::shared_ptr<const Journal>& journal() const { return journal_; }
  Step steps() const { return static_cast<Step>(conditions_.size()); }
  std::size_t events() const { return events_; }
  /// The condition that asked for an operation.
  Condition condition(Step step) const { return static_cast<Condition>(conditions_[step]); }
  /// How many of the operations in [begin, end) each condition asked for.
  std::array<std::uint32_t, condition_count> counts(Step begin, Step end) const;
  Stage stage(Step step) const { return static_cast<Stage>(stage_of_[step]); }
  EventKind kind(Step step) const { return static_cast<EventKind>(kind_of_[step]); }
  /// How many of the operations in [begin, end) are of a kind.
  std::uint32_t count(EventKind kind, Step begin, Step end) const;
  /// How many edges were rejected for a reason while the step was in [begin, end); with end = steps() + 1
  /// also those after the last operation.
  std::uint32_t rejections(Reason reason, Step begin, Step end) const;
  /// The steps of the rejections for a reason, ascending.
  const std::vector<Step>& rejections(Reason reason) const {
    return rejections_[static_cast<std::size_t>(reason)];
  }
  /// The first step of a stage, where it has begun.
  std::optional<Step> begin_of(Stage stage) const;
  /// The first operation that names a vertex as its own.
  std::optional<Step> birth_of(VertexId vertex) const;
  /// Values by operation. `seconds` runs on from stage to stage: value k is the figure after step k + 1.
  const std::vector<float>& values(Figure figure) const { return figures_[static_cast<std::size_t>(figure)]; }
  const std::vector<StageSpan>& stages() const { return stages_; }
  const std::vector<Mark>& marks() const { return marks_; }
  /// The next step after `from` whose operation has another condition or stage than the one at `from`.
  std::optional<Step> next_change(Step from) const;
  /// The first event with event.step >= step; events() when there is none.
  std::size_t first_event_at(Step step) const;

 private:
  std::shared_ptr<const Journal> journal_;
  std::size_t events_ = 0;
  std::vector<std::uint8_t> conditions_, stage_of_, kind_of_;
  std::array<std::vector<Step>, event_kind_count> operations_;   ///< steps by kind, ascending
  std::array<std::vector<Step>, reason_count> rejections_;       ///< steps by reason, ascending
  std::unordered_map<std::uint32_t, Step> births_;               ///< of vertices
  float seconds_before_ = 0;                                     ///< of the stages before the present one
  std::array<std::vector<std::uint32_t>, condition_count> sums_; ///< prefix sums, one longer than conditions_
  std::array<std::vector<float>, figure_count> figures_;
  std::vector<StageSpan> stages_;
  std::vector<Mark> marks_;
};

} // namespace isoscope
