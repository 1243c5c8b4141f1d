// Where and on what a run spends its work: places by number of insertions or attempts, time by stage and
// reason, and why nothing is accepted any more.
#pragma once

#include "journal/journal.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// Which events are counted.
enum class WorkKind : std::uint8_t {
  insertions, ///< Steiner points (§2.3)
  attempts,   ///< edges that were tried, collapsed or not (§2.4)
  rejections  ///< those that were not collapsed
};

/// Where an event took place: the Steiner point, the middle of the edge as it was, else the witness of an
/// exhausted tetrahedron. Nothing for events without place.
class EventPlaces {
 public:
  explicit EventPlaces(const Journal& journal) : journal_(&journal) {}
  /// For events in the order of the journal; each call goes on from the last one.
  std::optional<Vec3> place(std::size_t event);

 private:
  const Journal* journal_;
  Step step_ = 0; ///< operations whose vertices are known
  std::vector<Vec3> vertices_;
};

/// A cube of space and how much happened in it.
struct WorkCell {
  std::array<std::int32_t, 3> cell{}; ///< times the size: its lowest corner
  Vec3 center;
  std::uint32_t count = 0;
  Reason reason = Reason::none; ///< the most frequent one
};

struct WorkMap {
  double cell_size = 0;
  std::size_t total = 0;
  std::vector<WorkCell> cells; ///< the busiest first, ties by cell
};
/// Over the events in [begin, end); `cell_size` > 0, a length.
WorkMap map_work(const Journal& journal, std::size_t begin, std::size_t end, WorkKind kind, double cell_size);

/// The last attempts before an event: why nothing, or little, is accepted.
struct StallReport {
  static constexpr std::size_t bands = 40;
  using Counts = std::array<std::uint32_t, reason_count>; ///< by Reason; Reason::none: accepted
  std::size_t attempts = 0, accepted = 0;
  std::size_t since_accepted = 0; ///< attempts after the last accepted one, of all there were
  Counts by_reason{};
  std::vector<Counts> over_time; ///< at most `bands` stretches of attempts, oldest first
  std::size_t first_event = 0;   ///< the oldest attempt looked at
  WorkMap places;                ///< of the rejections
};
/// Attempts are insertions and exhausted tetrahedra, collapses and rejections.
StallReport examine_stall(const Journal& journal, std::size_t end, std::size_t most_attempts,
                          double cell_size, std::size_t begin = 0);

/// Time of a stage by what was decided. Operations have time stamps; what was tried in vain between two of
/// them shares their time evenly.
struct WorkTime {
  Stage stage = Stage::refinement;
  EventKind kind = EventKind::insertion;
  Reason reason = Reason::none;
  std::size_t count = 0;
  double seconds = 0;
};
/// Over the events in [begin, end); by stage, then the longest first.
std::vector<WorkTime> time_by_reason(const Journal& journal, std::size_t begin, std::size_t end);

} // namespace isoscope
