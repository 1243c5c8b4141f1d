// Figures per stage, condition and reason, gathered from the journal alone.
#pragma once

#include "journal/journal.h"

#include <array>
#include <cstddef>
#include <vector>

namespace isoscope {

/// What happened in one stage.
struct StageStatistics {
  using ReasonCounts = std::array<std::size_t, reason_count>; ///< by Reason
  Stage stage = Stage::refinement;
  double seconds = 0;                                    ///< from its begin to its end, pauses included
  std::size_t operations = 0;                            ///< of all kinds
  std::array<std::size_t, condition_count> insertions{}; ///< by Condition
  std::size_t collapses = 0;                             ///< without a repair
  std::size_t repairs = 0;                               ///< collapses with a repaired neighbourhood
  std::size_t repair_sweeps = 0;                         ///< inside the repairs
  std::size_t failed_repairs = 0;                        ///< rolled back: among `rejected`
  std::size_t failed_repair_sweeps = 0;                  ///< inside those
  std::size_t relaxations = 0;                           ///< sweeps over the whole of Z
  std::size_t shakes = 0;                                ///< passes of flips against the energy
  ReasonCounts found{};    ///< collapses, with repair or without, by how their target was found
  ReasonCounts rejected{}; ///< edges not collapsed, and exhausted tetrahedra, by reason; the same one may
                           ///< come again
  std::size_t zero_set_vertices = 0; ///< at its end

  std::size_t rejections() const;
  /// Zero when there was no operation.
  double seconds_per_operation() const;
};

/// One entry per stage that began, in order; a stage that begins again right after itself goes on with its
/// entry.
std::vector<StageStatistics> gather_statistics(const Journal& journal);

} // namespace isoscope
