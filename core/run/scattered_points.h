// Points that do not hang together at a tolerance.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/point_field.h"

#include <optional>

namespace isoscope {

/// Of points that may be of an open surface: an error of code open_surface where Ω' has no place for more
/// than half of them, as φ at them exceeds δ or they lie in small parts that were left out. Names the largest
/// of those, and the least tolerance, to a tenth, from which on half of the points are in one part. `kept`:
/// what Ω' is of, once blobs are left out.
std::optional<Error> scattered(const MadePointField& kept, const ToleranceVolume& volume,
                               const RunControl& control);

} // namespace isoscope
