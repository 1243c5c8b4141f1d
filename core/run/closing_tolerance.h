// The smallest tolerance at which an input is taken that is refused at a smaller one: what its refusal tells.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "run/parameters.h"
#include "tolerance/tolerance_volume.h"

#include <memory>

namespace isoscope {

/// An input that is refused at a tolerance.
struct RefusedInput {
  std::shared_ptr<const ToleranceField> field;
  InputTopology topology;
  double area = 0;                  ///< of the input
  ToleranceVolume::Options options; ///< with that tolerance
};

/// The refusal of an open input with a remedy that names the smallest tolerance up to half of the longest
/// edge at which the run begins, or says that none closes the input. Found to 3 % by building Ω at larger
/// tolerances, the coarsest first, with at most about three million cells in all; then refined there to be
/// sure. Comes back as it is when cancelled.
Error with_closing_tolerance(Error open, const RefusedInput& input, const RunParameters& parameters,
                             const RunControl& control);

/// The same of sheets that meet, cross or lie too near to each other, which may be open at the tolerance that
/// is sought: the remedy goes on with the smallest one found at which a run begins.
Error with_separating_tolerance(Error refused, const RefusedInput& input, const RunParameters& parameters,
                                const RunControl& control);

/// The refusal of a run that found parts with a border too near to each other: a smaller tolerance helps,
/// unless the input is refused there. Of three halvings, within the same limits, the first with a refusal is
/// named with it.
Error with_smaller_tolerance(Error refused, const RefusedInput& input, const RunParameters& parameters,
                             const RunControl& control);

} // namespace isoscope
