// What Ω makes of open surfaces where it does not keep them, in words.
#pragma once

#include "base/run_control.h"
#include "tolerance/boundary_sampler.h"

#include <cstddef>
#include <optional>
#include <string>

namespace isoscope {

/// What Ω makes of open surfaces, as the input's numbers tell it: χ(∂Ω) = 2 χ(Ω), a component for each of
/// Ω, a closed curve of the border for each loop of the open rim.
struct OpenTopology {
  long boundary_characteristic = 0; ///< of ∂Ω, all components but shallow ones
  std::size_t components = 0, loops = 0;
  bool is_of_input = false; ///< the input is a manifold with half that χ, these components and loops
};
OpenTopology open_topology(const ToleranceVolume& volume);

/// Where χ of Ω, its components or the loops of the open rim are not those of the input: a sentence with both
/// and a place of what Ω closes, inside the sheet where only one of its sides is left, else at its border.
/// Nothing where there are no triangles to compare with. `samples`: those of ∂Ω'.
std::optional<std::string> open_changes(const ToleranceVolume& volume, const BoundarySamples& samples,
                                        const RunControl& control);

} // namespace isoscope
