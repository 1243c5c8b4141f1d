// A run that goes on from a step of another one: with a collapse that a person asked for, or with other
// parameters.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "journal/journal.h"
#include "run/parameters.h"

#include <memory>
#include <string>

namespace isoscope {

/// Where a run leaves another one.
struct BranchPoint {
  std::shared_ptr<const Journal> from;
  Step step = 0; ///< the state that it begins with
  VertexId a, b; ///< the edge that is collapsed first; invalid: it goes on with parameters of its own
  Vec3 target;   ///< to this point
  bool by_hand() const { return a.valid(); }
};

/// The stage that a step belongs to, as events before the operation that leads on say.
struct StageAt {
  Stage stage = Stage::setup;
  bool open = false;  ///< it has not ended there
  double seconds = 0; ///< since it began, as the last operation before says
};
StageAt stage_at(const Journal& journal, Step step);

/// Whether Z begins outside of T: then the run has none at any step.
bool begins_outside_of_t(const Journal& journal);

/// Whether a run can leave there with a collapse: the refinement has ended and Z is still in T. Fails with
/// usage.
Status can_branch(const Journal& journal, Step step);
/// Whether it can leave there with other parameters: at any step before the improver's first. Fails with
/// usage.
Status can_go_on(const Journal& journal, Step step);
/// How many events the run that is left and the branch have in common. With parameters of its own a branch
/// goes on right behind the operation that led to its step, as what comes then was decided with the old ones.
std::size_t common_events(const BranchPoint& branch);
/// The stage in which a run goes on from there with other parameters: that of the operation that led there.
Stage stage_to_go_on(const Journal& journal, Step step);

/// From where a journal's beginning is made once more, to come to the state of an algorithm that it does not
/// hold: queues, what was given up, how far a batch is. Stages of the simplification begin with T alone, and
/// so does what comes after a collapse by hand; the refinement is repeated as a whole.
struct RehearsalStart {
  Stage stage = Stage::refinement;
  std::size_t event = 0; ///< the first that is made once more
  Step step = 0;         ///< the state before it
  bool by_hand = false;  ///< it is a collapse that a person asked for
};
RehearsalStart rehearsal_start(const Journal& prefix);

/// What a journal began with, where `parameters` are those of a later time.
RunParameters parameters_at_start(RunParameters parameters, const Journal& journal);

/// One line for reports and the journal: "branched at step 120: edge 5 - 9 collapsed by hand".
std::string describe(const BranchPoint& branch);

} // namespace isoscope
