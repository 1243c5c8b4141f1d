// What the samples around open surfaces say of their sides together (§4.1).
#pragma once

#include "tolerance/boundary_sampler.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

struct SideVotes {
  std::vector<std::int8_t> labels; ///< by sample; 0: over the rim after all
  Rim rim;                         ///< with the bridged pieces open that part two sides
  std::vector<SideVote> votes; ///< samples near to those whose side is not the one that their normal tells
  /// A point of the input, far from the rim, near to which no surface separates its sides: much of what is
  /// joined is on each of them there, or all that is around it is on one, so that it would be lost.
  std::optional<Vec3> inseparable;
};

/// Joins the samples that are on some side of an open surface where they are nearer than 2σ to each other;
/// what is joined is on the side of the most of it, unless it is on both. Bridged pieces of the rim with
/// samples of both sides within 2σ over them are contested: there the sheet ends after all, by less than Ω
/// is thick. Says nothing where σ is too large against δ' to tell the sides apart. `samples.labels` must be
/// those by normals. Of no use once the control is cancelled.
SideVotes vote_on_sides(const ToleranceVolume& volume, const BoundarySamples& samples,
                        const RunControl& control);

} // namespace isoscope
