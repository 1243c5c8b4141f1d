// What Ω makes of open surfaces where it does not keep them, in words.
#pragma once

#include "base/run_control.h"
#include "tolerance/boundary_sampler.h"

#include <optional>
#include <string>

namespace isoscope {

/// Where χ of Ω, its components or the loops of the open rim are not those of the input: a sentence with both
/// and a place of what Ω closes, inside the sheet where only one of its sides is left, else at its border.
/// Nothing where there are no triangles to compare with. `samples`: those of ∂Ω'.
std::optional<std::string> open_changes(const ToleranceVolume& volume, const BoundarySamples& samples,
                                        const RunControl& control);

} // namespace isoscope
