// The moments of a run that a talk is made of: chosen by what they teach, each with the event it speaks of.
#pragma once

#include "journal/journal.h"

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// A step worth staying at.
struct TalkMoment {
  Step step = 0;           ///< at which it is seen
  std::uint32_t event = 0; ///< of the journal
  friend bool operator==(const TalkMoment&, const TalkMoment&) = default;
};

/// Finds where stages begin and end, the first insertions, the first of each condition (before and after it
/// is mended), of each kind of operation in a stage, of each reason for which an edge stays, each change of
/// Z's topology, each warning, and in each stage the first collapse that comes after many that failed.
class Moments {
 public:
  static constexpr std::uint32_t first_insertions = 10;
  /// Edges that must have stayed before a collapse counts as one that comes at last.
  static constexpr std::uint32_t patience = 50;

  /// Starts anew for another journal.
  void reset(std::shared_ptr<const Journal> journal);
  const std::shared_ptr<const Journal>& journal() const { return journal_; }
  /// Takes in at most `budget` new events.
  void update(std::size_t budget = 20000);
  /// By step, those of one step by event; several may share a step, an event is there twice at most.
  const std::vector<TalkMoment>& all() const { return all_; }
  /// Their steps, one each: repeated where several share a step.
  std::span<const Step> steps() const { return steps_; }
  /// The first and the last one at a step, as [begin, end) of all().
  struct Range {
    std::size_t begin = 0, end = 0;
  };
  Range at(Step step) const;

 private:
  void take(std::uint32_t index, const Event& event);
  void take_operation(std::uint32_t index, const Event& event);
  void add(Step step, std::uint32_t event);

  std::shared_ptr<const Journal> journal_;
  std::size_t taken_ = 0;
  std::uint32_t inserted_ = 0; ///< by operations of any condition
  std::uint32_t rejected_ = 0; ///< edges in a row
  std::bitset<condition_count> conditions_;
  std::bitset<reason_count> reasons_;
  std::bitset<stage_count * event_kind_count> kinds_; ///< of operations, by stage
  std::bitset<stage_count> at_last_;                  ///< stages whose long-awaited collapse was found
  bool checked_ = false;                              ///< the two below are known
  double euler_ = 0;
  std::uint32_t components_ = 0;
  std::vector<TalkMoment> all_;
  std::vector<Step> steps_;
};

} // namespace isoscope
