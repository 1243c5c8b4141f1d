// The two sides of sheets that have no triangles to tell them: from samples around them, by balls that find
// where a sheet ends (§4.1).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/boundary_sampler.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// What samples say of the sides.
struct SheetSides {
  std::vector<std::int8_t> labels;  ///< by sample: ±1 around sheets, 0 elsewhere
  std::size_t boundary_samples = 0; ///< those that the balls found near to the end of a sheet, B
};

/// Balls of radius γδ' around sites: where the samples of ∂Ω' in one hang together, by steps of 2σ, the sheet
/// ends there, and they are B. What is left of the others by such steps are pieces of sides; two that lie
/// across from each other are different sides, others that meet are one. What is in B is on the side that is
/// nearest along the samples. B grows by steps where both sides hang together all the same.
/// `sheets`: a 1 by component of Ω' for those that are asked for. `gamma`: above 1. Fails with open_surface,
/// naming the place, where a sheet has one side only, or is all B.
Result<SheetSides> tell_sheet_sides(const ToleranceVolume& volume, const BoundarySamples& samples,
                                    std::span<const std::uint8_t> sheets, double gamma,
                                    const RunControl& control);

} // namespace isoscope
