// One sweep over all of Z: every vertex is relocated, every edge flipped, where that lowers the energy.
#pragma once

#include "base/run_control.h"
#include "improve/live_surface.h"

namespace isoscope {

/// What came to nothing, by vertex and by facet: the number of commits when a relocation or a flip was found
/// to gain nothing or failed its checks. It would do so again until something changes there.
struct InVain {
  std::vector<std::uint32_t> relocations, flips;
};

/// What a sweep did.
struct RelaxationFigures {
  std::uint32_t moved = 0, flipped = 0;
  double largest = 0; ///< sampled d of the facets that it changed
};

/// Relocations in batches of vertices that are not neighbours, then flips; each is certified and tested
/// before it is committed. What came to nothing where nothing has changed since is left out. Stops
/// early, with a valid surface, when cancelled. The result does not depend on the number of threads.
RelaxationFigures relax(LiveSurface& surface, const SurfaceRules& rules, InVain& in_vain,
                        const RunControl& control);

} // namespace isoscope
