// The X-ray of the selected edge in the inspector.
#pragma once

#include "edge/probe.h"
#include "ui/ui.h"

namespace isoscope::panels {

/// Verdict, checks, kernel, candidates, cost; after T what the journal tells.
void edge_details(Ui& ui, EdgeProbe& probe, const StateSnapshot& state);

} // namespace isoscope::panels
