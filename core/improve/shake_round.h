// One pass of edge flips against the energy: leaves a minimum from which no edge collapses.
#pragma once

#include "base/run_control.h"
#include "improve/live_surface.h"

#include <limits>

namespace isoscope {

struct ShakeOptions {
  std::uint32_t pass = 0;                                              ///< chooses the order of the edges
  std::size_t most_attempts = std::numeric_limits<std::size_t>::max(); ///< after these no batch is begun
  RepairOptions repair;                                                ///< of each flip
  int rings = 1; ///< free vertices: this many edges from the ends of the flipped one
};

struct ShakeFigures {
  std::size_t attempts = 0;
  std::uint32_t flipped = 0; ///< flips against the energy that were committed
  double largest = 0;        ///< sampled d of the changed facets
  bool all_tried = false;    ///< every edge that might be flipped was
};

/// Tries every edge once in an order that follows from ids and `pass`: flips it whatever the energy becomes,
/// repairs its neighbourhood, and commits what is proven as any collapse with repair
/// is. In parallel, in batches of a size that does not depend on the threads, of which flips that come too
/// late are tried again; the result does not depend on the number of threads. Stops early, with a valid
/// surface, when cancelled.
ShakeFigures shake(LiveSurface& surface, const SurfaceRules& rules, const ShakeOptions& options,
                   const RunControl& control);

} // namespace isoscope
