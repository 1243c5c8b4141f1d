// Read off the journal's events.
#include "run/branch.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

bool is_by_hand(const Event& e) {
  return e.kind == EventKind::collapse && e.reason == Reason::user;
}

} // namespace

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

bool begins_outside_of_t(const Journal& journal) {
  return !journal.operations().empty() &&
         journal.events()[journal.operations()[0].event].kind == EventKind::start;
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
  if (begins_outside_of_t(journal))
    return Error{ErrorCode::usage, "This run has no T: Z began outside of it.",
                 "Restart with --start delaunay to collapse edges by hand."};
  return {};
}

Stage stage_to_go_on(const Journal& journal, Step step) {
  const std::size_t operations = std::min<std::size_t>(step, journal.operations().size());
  if (operations == 0) return Stage::refinement;
  const Stage stage = journal.events()[journal.operations()[operations - 1].event].stage;
  return stage == Stage::setup ? Stage::refinement : stage;
}

Status can_go_on(const Journal& journal, Step step) {
  if (step == 0 || step > journal.operations().size())
    return Error{ErrorCode::usage, "Nothing is done at this step yet.", "Restart with these parameters."};
  for (std::size_t k = 0; k < step; ++k) {
    const Event& e = journal.events()[journal.operations()[k].event];
    if (e.stage == Stage::improve || e.kind == EventKind::fill)
      return Error{ErrorCode::usage, "The improver has begun: what it does depends on no parameter any more.",
                   "Go to a step before the last stage, or restart."};
  }
  return {};
}

std::size_t common_events(const BranchPoint& branch) {
  const Journal& from = *branch.from;
  const std::size_t operations = std::min<std::size_t>(branch.step, from.operations().size());
  if (!branch.by_hand()) return operations == 0 ? 0 : from.operations()[operations - 1].event + 1u;
  return operations < from.operations().size() ? from.operations()[operations].event : from.events().size();
}

RehearsalStart rehearsal_start(const Journal& prefix) {
  const Stage last = stage_to_go_on(prefix, prefix.steps());
  const bool certified = prefix.parameters().empty() || prefix.parameters()[0].criteria.certified;
  // Samples on facets between tetrahedra are where history has put them: with samples to be followed, all
  // stages of the simplification are made once more.
  const Stage first_wanted = certified ? last : Stage::gamma;
  RehearsalStart start;
  bool found = false, begun = false;
  for (std::size_t i = 0; i < prefix.events().size(); ++i) {
    const Event& e = prefix.events()[i];
    if (is_by_hand(e)) {
      start = {e.stage, i, e.step, true};
      found = true;
      begun = false; // what comes after it is nearer
    } else if (e.kind == EventKind::stage_begin && comes_after(e.stage, Stage::refinement) &&
               !comes_after(first_wanted, e.stage) && !begun && !(start.by_hand && !certified)) {
      start = {e.stage, i, e.step, false};
      found = begun = true;
    } else if (e.kind == EventKind::stage_begin && e.stage == Stage::refinement && !found) {
      start = {Stage::refinement, i, e.step, false};
      found = true;
    }
  }
  return start;
}

RunParameters parameters_at_start(RunParameters parameters, const Journal& journal) {
  if (journal.parameters().empty()) return parameters;
  const CriteriaParameters& c = journal.parameters()[0].criteria;
  // Of the ratios next to σ/δ, one that gives σ back to the bit.
  const double ratio = c.sigma / c.delta;
  for (const double next : {std::nextafter(ratio, 0.0), std::nextafter(ratio, 2.0), ratio})
    if (next * c.delta == c.sigma) parameters.sigma = next;
  parameters.alpha = c.alpha;
  parameters.shrink = c.shrink;
  parameters.conditions = {c.condition_1, c.condition_2, c.condition_3, c.condition_4};
  return parameters;
}

std::string describe(const BranchPoint& branch) {
  if (!branch.by_hand())
    return "branched at step " + std::to_string(branch.step) + " with parameters of its own";
  return "branched at step " + std::to_string(branch.step) + ": edge " + std::to_string(branch.a.value) +
         " - " + std::to_string(branch.b.value) + " collapsed by hand";
}

} // namespace isoscope
