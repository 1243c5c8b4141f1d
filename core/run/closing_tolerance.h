// The smallest tolerance at which an open input has two sides, where one does: what its refusal tells.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/parameters.h"
#include "tolerance/tolerance_volume.h"

#include <memory>

namespace isoscope {

/// An input that is open at a tolerance.
struct OpenInput {
  std::shared_ptr<const ClosestPointIndex> index;
  InputTopology topology;
  double area = 0;                  ///< of the input
  ToleranceVolume::Options options; ///< with the tolerance at which it is open
};

/// The refusal with a remedy that names the smallest tolerance up to half of the longest edge at which the
/// run begins, or says that none closes the input. Found to 3 % by building Ω at larger tolerances, the
/// coarsest first, with at most about three million cells in all; then refined there to be sure. Comes back
/// as it is when cancelled.
Error with_closing_tolerance(Error open, const OpenInput& input, const RunParameters& parameters,
                             const RunControl& control);

} // namespace isoscope
