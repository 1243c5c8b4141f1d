// A run that goes on from a step of another one, with a collapse that a person asked for.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "journal/journal.h"

#include <memory>
#include <string>

namespace isoscope {

/// Where a run leaves another one.
struct BranchPoint {
  std::shared_ptr<const Journal> from;
  Step step = 0; ///< the state that it begins with
  VertexId a, b; ///< the edge that is collapsed first
  Vec3 target;   ///< to this point
};

/// The stage that a step belongs to, as events before the operation that leads on say.
struct StageAt {
  Stage stage = Stage::setup;
  bool open = false;  ///< it has not ended there
  double seconds = 0; ///< since it began, as the last operation before says
};
StageAt stage_at(const Journal& journal, Step step);

/// Whether a run can leave there: the refinement has ended and Z is still in T. Fails with usage.
Status can_branch(const Journal& journal, Step step);
/// One line for reports and the journal: "branched at step 120: edge 5 - 9 collapsed by hand".
std::string describe(const BranchPoint& branch);

} // namespace isoscope
