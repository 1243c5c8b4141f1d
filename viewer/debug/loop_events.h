// The events that work on the loops of the open rim, loop by loop, gathered a little at a time: what the
// timeline has lanes for.
#pragma once

#include "questions/loop_events.h"
#include "questions/snapshot.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Stands for all loops without a lane of their own.
inline constexpr std::uint32_t other_loops = 0xffffffffu;

/// "loop-3", as the list of holes counts from one, and "loops-other".
std::string loop_lane_name(std::uint32_t loop);
std::optional<std::uint32_t> loop_of_lane(std::string_view name);

class LoopEvents {
 public:
  /// So many loops, the longest, have a lane of their own, where there are more than that and one.
  static constexpr std::size_t most_single = 8;

  /// Takes in at most `budget` further events; begins anew where the journal is another. Without an open rim
  /// nothing is found. True when something came.
  bool update(const std::shared_ptr<const Journal>& journal, const std::shared_ptr<const Scene>& scene,
              std::size_t budget = 20000);
  bool complete() const;
  /// How many events have been judged.
  std::uint32_t scanned() const { return scanned_; }

  /// The loops that have lanes, the longest first, then other_loops where there are any.
  const std::vector<std::uint32_t>& lanes() const { return lanes_; }
  /// Whether there is such a loop, or such others.
  bool has(std::uint32_t loop) const;
  /// "hole 3", "98 other holes".
  std::string title(std::uint32_t loop) const;
  /// Indices of events, ascending; none of what there is not.
  const std::vector<std::uint32_t>& events(std::uint32_t loop) const;
  bool touches(std::uint32_t loop, std::uint32_t event) const;
  /// How many operations did this to the loop while the step was in [begin, end).
  std::uint32_t count(std::uint32_t loop, LoopWork work, Step begin, Step end) const;
  std::uint32_t count(std::uint32_t loop, Step begin, Step end) const;

 private:
  struct Row {
    std::vector<std::uint32_t> events;
    std::array<std::vector<Step>, loop_work_count> steps;
  };
  void restart();
  const Row* row(std::uint32_t loop) const;

  std::shared_ptr<const Journal> journal_;
  std::shared_ptr<const Scene> scene_;
  const Rim* rim_ = nullptr; ///< of the scene
  std::uint32_t scanned_ = 0;
  std::vector<std::uint32_t> lanes_;
  std::vector<Row> rows_; ///< by loop
  Row others_;
  std::vector<std::uint8_t> single_; ///< by loop: it has a lane of its own
};

} // namespace isoscope
