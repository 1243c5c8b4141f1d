// The link conditions: whether collapsing an edge keeps T, Z and the strata of Z what they are (§2.4, Figure
// 6, core/README.md, N8).
#pragma once

#include "base/ids.h"
#include "mesh/edge_star.h"

#include <vector>

namespace isoscope {

/// Lk(a) ∩ Lk(b) = Lk(ab), in T, in Z and in its curves [Dey et al. 1998], and never two points of Z. In Z
/// and in the curves it is asked of embedded stars with both ends there, and then ab itself must be there.
/// Facets that are dropped count as facets of Z.
struct LinkVerdict {
  bool holds_in_t = true, holds_in_zero_set = true;
  bool holds_on_curves = true; ///< asked where it holds in Z
  /// Simplices (1 to 3 vertices, by ascending local number) of both links that are not in Lk(ab); the edge ab
  /// itself where both ends are on Z, or on curves of it, and ab is not. Filled when asked for.
  std::vector<std::vector<VertexId>> offending_t, offending_zero; ///< the second: in Z or on its curves
  bool holds() const { return holds_in_t && holds_in_strata(); }
  bool holds_in_strata() const { return holds_in_zero_set && holds_on_curves; }
};

/// Without offenders it stops at the first violation, and looks at Z only where T passed.
LinkVerdict check_link(const EdgeStar& star, bool list_offenders);

} // namespace isoscope
