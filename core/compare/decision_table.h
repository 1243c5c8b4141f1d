// Which points went in and which edges collapsed in one run and not in the other, matched by place: ids of
// vertices mean nothing across runs.
#pragma once

#include "base/run_control.h"
#include "journal/journal.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace isoscope {

/// A decision that one run made and the other did not.
struct DecisionDifference {
  Stage stage = Stage::refinement; ///< of the run that made it
  bool made_by_a = false;
  std::uint32_t event = 0;              ///< of that run: an insertion, a collapse or a collapse with repair
  std::optional<std::uint32_t> refusal; ///< of the other run: the last time that it refused the same edge
  Vec3 place;                           ///< the point, or the middle of the edge
};

/// Decisions made in a stage by both runs (in whichever stage the other made it) and by one of them.
struct StageDecisions {
  Stage stage = Stage::refinement;
  std::size_t both = 0, only_a = 0, only_b = 0;
};

struct DecisionTable {
  std::vector<StageDecisions> stages;   ///< those with decisions, in the paper's order
  std::vector<DecisionDifference> rows; ///< by stage and then by step; at most `row_limit` a stage and run
  std::size_t both() const;
  std::size_t only_a() const;
  std::size_t only_b() const;
  static constexpr std::size_t row_limit = 100;
};

/// Of the events from number `from` on, before which both journals are the same. A point matches a point at
/// the very same place, an edge one whose ends were at the very same places when it was decided. What is
/// found so far when cancelled.
DecisionTable differing_decisions(const Journal& a, const Journal& b, std::size_t from,
                                  const RunControl& control);

} // namespace isoscope
