// What a cut along the rim would make of Z: condition 4 of open surfaces (§4.1).
#pragma once

#include "base/run_control.h"
#include "criteria/topology.h"
#include "mesh/complex.h"
#include "tolerance/tolerance_volume.h"

namespace isoscope {

/// Whether an open surface is to have what the input has, so that Z can be held against that before it is
/// cut.
bool is_tried(const ToleranceVolume& volume, const ExpectedTopology& expected);

/// Cuts a copy of T as the stages do, and leaves no trace. As expected only where the cut comes to its end.
TopologyVerdict try_cut(const Complex& refined, const ToleranceVolume& volume,
                        const ExpectedTopology& expected, const RunControl& control);

} // namespace isoscope
