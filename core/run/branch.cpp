// Read off the journal's events.
#include "run/branch.h"

#include <algorithm>

namespace isoscope {

StageAt stage_at(const Journal& journal, Step step) {
  StageAt at;
  const std::size_t operations = std::min<std::size_t>(step, journal.operations().size());
  const std::size_t end = operations < journal.operations().size() ? journal.operations()[operations].event
                                                                   : journal.events().size();
  for (std::size_t i = 0; i < end; ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::stage_begin) at.stage = e.stage, at.open = true;
    if (e.kind == EventKind::stage_end || e.kind == EventKind::stopped) at.open = false;
  }
  if (operations > 0) {
    const Operation& last = journal.operations()[operations - 1];
    if (journal.events()[last.event].stage == at.stage) at.seconds = last.figures.seconds;
  }
  return at;
}

Status can_branch(const Journal& journal, Step step) {
  const StageAt at = stage_at(journal, step);
  if (at.stage < Stage::refinement || (at.stage == Stage::refinement && at.open))
    return Error{ErrorCode::usage, "Edges are collapsed once the refinement has ended.",
                 "Go to a step of a later stage."};
  for (std::size_t k = 0; k < step && k < journal.operations().size(); ++k)
    if (journal.events()[journal.operations()[k].event].kind == EventKind::departure)
      return Error{ErrorCode::usage, "Z has left T: edges of T are not collapsed any more.",
                   "Go to a step before the last stage."};
  return {};
}

std::string describe(const BranchPoint& branch) {
  return "branched at step " + std::to_string(branch.step) + ": edge " + std::to_string(branch.a.value) +
         " - " + std::to_string(branch.b.value) + " collapsed by hand";
}

} // namespace isoscope
