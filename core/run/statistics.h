// Figures per stage and condition, gathered from the journal alone.
#pragma once

#include "journal/journal.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace isoscope {

struct StageStatistics {
  Stage stage = Stage::refinement;
  double seconds = 0;
  std::size_t operations = 0;
  std::array<std::size_t, condition_count> insertions{}; ///< by Condition
  std::map<std::string, std::size_t> rejected;           ///< exhausted events by reason's name
  std::size_t zero_set_vertices = 0;                     ///< at its end
};

/// One entry per stage that began, in order.
std::vector<StageStatistics> gather_statistics(const Journal& journal);

} // namespace isoscope
