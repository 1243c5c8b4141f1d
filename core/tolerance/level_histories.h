// Merge trees of φ over the leaves of an octree: at which levels components come and at which they join.
#pragma once

#include "base/run_control.h"
#include "tolerance/field_octree.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// A component of {φ > δ} or of {φ < δ}, from the δ at which it appears to that at which it joins an older
/// one.
struct LevelPair {
  double birth, death;
  std::uint32_t at, saddle; ///< leaves
};

/// What ended of the components of {φ > δ} as δ shrinks, and of {φ < δ} as it grows; levels are right to a
/// thousandth. What lasts over less than a factor of a few hundredths is left out, as an effect of the cells.
struct LevelHistories {
  std::vector<LevelPair> regions, components;
};

/// Of no use once the control is cancelled. The same on any number of threads.
LevelHistories find_histories(const FieldOctree& octree, const RunControl& control);

} // namespace isoscope
