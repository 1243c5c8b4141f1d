// The Euler characteristic of each boundary component of Ω'.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <vector>

namespace isoscope {

/// χ of each of volume.boundary_components(), counted on the surface that marching tetrahedra make of the
/// signs of d - δ' at the corners of cells `halvings` times finer than the octree's main ones. Corners whose
/// region the octree cannot tell count as part of Ω'. Fails with cancelled only.
Result<std::vector<long>> boundary_characteristics(const ToleranceVolume& volume, unsigned halvings,
                                                   const RunControl& control);

} // namespace isoscope
