// The improver on a Z that has left T: its changes become operations of the journal (core/README.md, N6).
#pragma once

#include "collapse/collapse_checks.h"
#include "improve/improver.h"
#include "journal/stage_log.h"
#include "mesh/complex.h"

namespace isoscope {

/// Improves the free Z of `complex` in place until nothing is gained or the log says stop. Every change is
/// recorded; the state is valid after each.
ImproverOutcome improve_free_zero_set(Complex& complex, const EvaluationContext& context,
                                      const ImproverOptions& options, StageLog& log);

/// The same for the part of it in `ground.box`: the improver sees the facets whose boxes meet that one.
void improve_free_piece(Complex& complex, const ImproverGround& ground, const ImproverOptions& options,
                        StageLog& log);

} // namespace isoscope
