// A target that a person tries, and what would unlock the edge.
#pragma once

#include "edge/probe.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// Verdict, numbers before and after, where to snap, the branch.
void what_if(Ui& ui, const EdgeProbe& probe, const EdgeXray& xray);
/// Which neighbouring collapses would make this one possible.
void unlock(Ui& ui, EdgeProbe& probe);

} // namespace isoscope::panels
