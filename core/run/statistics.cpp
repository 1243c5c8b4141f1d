// One pass over the journal's events.
#include "run/statistics.h"

namespace isoscope {

std::vector<StageStatistics> gather_statistics(const Journal& journal) {
  std::vector<StageStatistics> stages;
  const std::size_t operations = journal.operations().size();
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::stage_begin) {
      stages.emplace_back();
      stages.back().stage = e.stage;
    }
    if (stages.empty()) continue;
    StageStatistics& s = stages.back();
    if (e.operation && e.step < operations) {
      ++s.operations;
      const StepFigures& figures = journal.operations()[e.step].figures;
      s.seconds = figures.seconds;
      s.zero_set_vertices = figures.zero_set_vertices;
    }
    if (e.kind == EventKind::insertion) ++s.insertions[static_cast<std::size_t>(e.condition)];
    if (e.kind == EventKind::exhausted) ++s.rejected[std::string(name(e.reason))];
  }
  return stages;
}

} // namespace isoscope
