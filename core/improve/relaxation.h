// One sweep over all of Z: every vertex is relocated, every edge flipped, where that lowers the energy.
#pragma once

#include "base/run_control.h"
#include "improve/live_surface.h"

namespace isoscope {

/// By vertex: number of commits when it was last found at its best place.
using BestPlaces = std::vector<std::uint32_t>;

/// What a sweep did.
struct RelaxationFigures {
  std::uint32_t moved = 0, flipped = 0;
  double largest = 0; ///< sampled d of the facets that it changed
};

/// Relocations in batches of vertices that are not neighbours, then flips; each is certified and tested
/// before it is committed. Vertices at their best place whose star has not changed since are left out. Stops
/// early, with a valid surface, when cancelled. The result does not depend on the number of threads.
RelaxationFigures relax(LiveSurface& surface, const SurfaceRules& rules, BestPlaces& best_places,
                        const RunControl& control);

} // namespace isoscope
