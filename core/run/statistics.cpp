// One pass over the journal's events.
#include "run/statistics.h"

#include <algorithm>
#include <numeric>

namespace isoscope {

namespace {

/// The time of one stage, from two sources: what operations say ends at the last one, what the marks say also
/// holds what was tried in vain after it.
class StageClock {
 public:
  /// A stage that begins again may count on or start from zero.
  void operation(double since_begin) {
    operations_ += since_begin >= last_operation_ ? since_begin - last_operation_ : since_begin;
    last_operation_ = since_begin;
  }
  void mark(bool begins, double now) {
    if (!begins) marks_ += now - began_;
    began_ = now;
  }
  double seconds() const { return std::max(operations_, marks_); }

 private:
  double operations_ = 0, last_operation_ = 0;
  double marks_ = 0, began_ = 0;
};

/// Adds one event to the figures of its stage.
void count(const Journal& journal, const Event& e, StageStatistics& s) {
  const auto reason = static_cast<std::size_t>(e.reason);
  const std::size_t sweeps = journal.repairs()[e.detail].size();
  switch (e.kind) {
  case EventKind::insertion:
    ++s.insertions[static_cast<std::size_t>(e.condition)];
    break;
  case EventKind::collapse:
    ++s.collapses;
    ++s.found[reason];
    break;
  case EventKind::repair:
    ++s.repairs;
    ++s.found[reason];
    s.repair_sweeps += sweeps;
    break;
  case EventKind::relaxation:
    ++s.relaxations;
    break;
  case EventKind::shake:
    ++s.shakes;
    break;
  case EventKind::rejection:
    ++s.rejected[reason];
    if (e.detail == 0) break;
    ++s.failed_repairs;
    s.failed_repair_sweeps += sweeps;
    break;
  case EventKind::exhausted:
    ++s.rejected[reason];
    break;
  default:
    break;
  }
}

} // namespace

std::size_t StageStatistics::rejections() const {
  return std::accumulate(rejected.begin(), rejected.end(), std::size_t{0});
}

double StageStatistics::seconds_per_operation() const {
  return operations > 0 ? seconds / static_cast<double>(operations) : 0;
}

std::vector<StageStatistics> gather_statistics(const Journal& journal) {
  std::vector<StageStatistics> stages;
  StageClock clock;
  const std::size_t operations = journal.operations().size();
  const std::size_t marks = journal.stage_marks().size();
  for (std::size_t i = 0, mark = 0, n = journal.events().size(); i < n; ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::stage_begin && (stages.empty() || stages.back().stage != e.stage)) {
      const std::size_t vertices = stages.empty() ? 0 : stages.back().zero_set_vertices;
      stages.emplace_back();
      stages.back().stage = e.stage;
      stages.back().zero_set_vertices = vertices;
      clock = {};
    }
    if (mark < marks && journal.stage_marks()[mark].event == i) {
      clock.mark(e.kind == EventKind::stage_begin, journal.stage_marks()[mark].seconds);
      ++mark;
    }
    if (stages.empty()) continue;
    StageStatistics& s = stages.back();
    if (e.operation && e.step < operations) {
      const StepFigures& figures = journal.operations()[e.step].figures;
      ++s.operations;
      s.zero_set_vertices = figures.zero_set_vertices;
      clock.operation(static_cast<double>(figures.seconds));
    }
    s.seconds = clock.seconds();
    count(journal, e, s);
  }
  return stages;
}

} // namespace isoscope
