// Why a change of T or of Z cannot be made: the first check that fails, with its figures.
#pragma once

#include "base/geometry.h"
#include "journal/event.h"

namespace isoscope {

/// `value` against `limit` as the reason says, at `witness`.
struct Refusal {
  Reason reason = Reason::none; ///< none: nothing is against it
  double value = 0, limit = 0;
  Vec3 witness;
  bool accepted() const { return reason == Reason::none; }
};

} // namespace isoscope
