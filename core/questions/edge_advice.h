// Which other α or shrink would let an edge collapse that stays: the evaluator asked again over values.
#pragma once

#include "base/run_control.h"
#include "questions/edge_xray.h"
#include "questions/element_questions.h"

#include <vector>

namespace isoscope {

/// α (condition 1, sampled mode) and the factor of condition 3, each alone; the other checks do not depend on
/// α, σ or shrink. `works`: the nearest smaller value found. Empty where there is no such edge.
std::vector<ParameterAdvice> advise_edge(const StateSnapshot& state, const EdgeQuestion& question,
                                         const XrayContext& context, const RunControl& control);

} // namespace isoscope
