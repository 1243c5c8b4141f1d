// As much of the star of an edge as its kind and its error follow from: queues ask for many more of them than
// are ever judged.
#pragma once

#include "mesh/incidence.h"

namespace isoscope {

/// Like gather_edge_star, but vertices besides the ends are listed once for each tetrahedron that has them,
/// and what lies beyond the ends of border edges is left out. The same kind and strata, and unless the kind
/// is `other` the same cost facets and borders.
EdgeStar gather_cost_star(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                          CostRing ring);

} // namespace isoscope
