// The improver inside T: its changes of Z are changes of T, whose tetrahedra stay positively oriented at each
// step (core/README.md, N6).
#pragma once

#include "collapse/collapse_checks.h"
#include "collapse/live_complex.h"
#include "improve/improver.h"
#include "journal/stage_log.h"

#include <functional>

namespace isoscope {

/// Improves the embedded Z of `live` until nothing is gained or the log says stop. Every change is recorded;
/// the state is valid after each. `make_room` is called between rounds: it may collapse edges of T where Z
/// stays what it is, and records that itself.
ImproverOutcome improve_embedded_zero_set(LiveComplex& live, const EvaluationContext& context,
                                          const ImproverOptions& options,
                                          const std::function<void()>& make_room, StageLog& log);

} // namespace isoscope
