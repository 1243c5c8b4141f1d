// The link condition: whether collapsing an edge keeps T and Z what they are (§2.4, Figure 6).
#pragma once

#include "base/ids.h"
#include "mesh/edge_star.h"

#include <vector>

namespace isoscope {

/// Lk(a) ∩ Lk(b) = Lk(ab), in T and in Z [Dey et al. 1998]. In Z it is asked of embedded stars with both ends
/// on Z, and then ab itself must be an edge of Z.
struct LinkVerdict {
  bool holds_in_t = true, holds_in_zero_set = true;
  /// Simplices (1 to 3 vertices, by ascending local number) of both links that are not in Lk(ab); the edge ab
  /// itself where both ends are on Z and ab is not. Filled when asked for.
  std::vector<std::vector<VertexId>> offending_t, offending_zero;
  bool holds() const { return holds_in_t && holds_in_zero_set; }
};

/// Without offenders it stops at the first violation, and looks at Z only where T passed.
LinkVerdict check_link(const EdgeStar& star, bool list_offenders);

} // namespace isoscope
