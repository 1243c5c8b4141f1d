// The part of the input that bounds its inside: what a mesh has to be near to.
#pragma once

#include "base/run_control.h"
#include "tolerance/tolerance_volume.h"

#include <memory>

namespace isoscope {

/// The input without its inner walls, which have the inside on both sides where closed parts overlap or
/// touch; the input itself where there can be none. Where a triangle is crossed by others it is cut into
/// pieces of at most `finest` (> 0, absolute), and those along the crossing are judged by their middles: what
/// is left out there is that near to what is kept. Not all of it when abandoned.
std::shared_ptr<const ClosestPointIndex> exposed_input(const ToleranceVolume& volume, double finest,
                                                       const RunControl& control);

} // namespace isoscope
