// Points inside of thin walls and narrow gaps that keep Z near to all of the input (core/README.md, N2).
#pragma once

#include "base/run_control.h"
#include "criteria/nearest_sample.h"
#include "tolerance/tolerance_volume.h"

#include <vector>

namespace isoscope {

/// A point of the input that has a sample, or a point that is held, of each side within a distance is that
/// near to Z, as Z passes between them. These are the points to be held where samples are farther away: of
/// walls thinner than 2δ' nothing but Ω is left, and Z could end where their inside does. Where samples are
/// near, but nothing anchors them (AnchoredSamples), some of them are held.
struct CoverWitnesses {
  std::vector<Witness> held; ///< Z keeps them on their side from the end of the refinement on
  std::vector<Witness> path; ///< from what has a region to those: they are on their side at that end
};

/// Of open parts that are thin at their rim the ends are joined through them, where no region is reached: a
/// tube stays one.
/// None of rooms, nor of soups where rays do not agree on a side, and where `limit` (absolute) is below 2δ:
/// there Ω alone decides. What is thin and has no way to a region of its side is left.
CoverWitnesses find_cover_witnesses(const ToleranceVolume& volume, const SearchedSamples& samples,
                                    double limit, const RunControl& control);

} // namespace isoscope
