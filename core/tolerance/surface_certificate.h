// The facet certificate for triangles, by branch and bound over corners (core/README.md, N4).
#pragma once

#include "tolerance/closest_point.h"
#include "tolerance/facet_certificate.h"

namespace isoscope {

/// certify_facet() where φ is the distance to triangles and every point beyond the limit violates. `field`
/// answers what is nearest among the triangles of `surface`.
FacetVerdict certify_on_surface(const ToleranceField& field, const ClosestPointIndex& surface,
                                const Triangle3& facet, double accept, double reject,
                                const FacetSearch& search);

} // namespace isoscope
