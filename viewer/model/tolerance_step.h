// What the study of tolerances says at one of them.
#pragma once

#include "tolerance/delta_study.h"

#include <algorithm>
#include <iterator>

namespace isoscope {

/// The last step of the curve up to δ; null below the first.
inline const DeltaStudy::Step* step_at(const DeltaStudy& study, double delta) {
  const auto next = std::upper_bound(study.curve.begin(), study.curve.end(), delta,
                                     [](double d, const DeltaStudy::Step& step) { return d < step.delta; });
  return next == study.curve.begin() ? nullptr : &*std::prev(next);
}

} // namespace isoscope
