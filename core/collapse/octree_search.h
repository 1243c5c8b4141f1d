// The paper's search: an octree over the kernel, without the cells that lie inside Ψ (§2.4.3).
#pragma once

#include "collapse/target_trial.h"

namespace isoscope {

/// Branch and bound: the cell whose error is bounded lowest comes first, its centre is a candidate, and the
/// search ends when no cell can hold less error than the best target found.
void search_octree(TargetTrial& trial, const TargetSearchOptions& options);

} // namespace isoscope
