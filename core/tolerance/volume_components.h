// The connected components of Ω' in terms of the input triangles.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"

namespace isoscope {

/// Two triangles are in one component of {d <= r} when a chain of triangles at most 2r apart joins them.
/// Numbered by their smallest triangle id. Of no use once the control is cancelled.
VolumeComponents find_volume_components(const ClosestPointIndex& index, double r,
                                        const RunControl& control = {});

} // namespace isoscope
