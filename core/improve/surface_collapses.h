// One greedy round of edge collapses in the order of their cost, with or without repair.
#pragma once

#include "base/run_control.h"
#include "collapse/collapse_queue.h"
#include "improve/live_surface.h"

#include <limits>

namespace isoscope {

/// Hears of everything that is committed or rolled back.
class ImproverObserver {
 public:
  virtual ~ImproverObserver() = default;
  /// After a commit; false stops the improver.
  virtual bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) = 0;
  /// After an attempt was rolled back; false stops the improver.
  virtual bool rejected(const ImproverVerdict& verdict) = 0;
};

struct CollapseRoundOptions {
  double cost_limit = 0; ///< edges are tried up to this cost, absolute
  std::size_t most_attempts = std::numeric_limits<std::size_t>::max(); ///< after these no batch is begun
  std::size_t most_in_vain =
      std::numeric_limits<std::size_t>::max(); ///< the same of tries in a row that fail
  int rings = 0;                               ///< free vertices: this many edges from the edge's ends
  RepairOptions repair;                        ///< repair.sweeps 0: without repair
  PlacementEffort placement;                   ///< of the targets
};

/// Edges that failed, with the number of commits by then. They are tried again only when something near them
/// has changed since: anything where they failed by little, a collapse otherwise.
using FailedEdges = FailedCollapses<std::uint32_t>;

struct CollapseRoundFigures {
  std::size_t attempts = 0, collapses = 0;
  bool stopped = false; ///< by the observer
};

/// Collapses until no edge below the limit can be. Costs and attempts are computed in parallel, in batches of
/// a size that does not depend on the threads, and committed in the order of the queue: without repair of
/// edges whose neighbourhoods are apart, with repair of any, of which those that come too late are tried
/// again. The result does not depend on the number of threads. Stops early, with a valid surface, when
/// cancelled.
CollapseRoundFigures collapse_round(LiveSurface& surface, const SurfaceRules& rules,
                                    const CollapseRoundOptions& options, FailedEdges& failed,
                                    const RunControl& control, ImproverObserver& observer);

} // namespace isoscope
