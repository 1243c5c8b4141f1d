// Passages between parts of the complement of Ω' that are wider than 2 δ' but narrower than the main cells
// show.
#pragma once

#include "base/run_control.h"
#include "tolerance/regions.h"

namespace isoscope {

/// Joins the components of OUT cells that such passages join, before they have numbers. Looks where the ways
/// over the largest φ down from two components meet; each has a basin of such ways. A passage along which φ
/// exceeds `reject` by a fortieth of `boundary` is found, unless it is so long and winding that a flood ends
/// before. Both are levels of φ, of δ_r and δ'.
void join_narrow_passages(Regions& octree, const ToleranceField& field, double boundary, double reject,
                          const RunControl& control);

} // namespace isoscope
