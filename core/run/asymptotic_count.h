// How few vertices a surface within δ of a smooth one can have, as δ becomes small: an estimate.
#pragma once

#include "input/triangle_soup.h"

#include <optional>

namespace isoscope {

/// A facet between d = δ on both sides of a surface with principal curvatures of one sign is largest where
/// it is equilateral in the metric that these make: then its corners lie δ outside, its middle δ inside, and
/// its area is 3√3 δ/√K. On a saddle the largest whose corners lie on it has 2√5 δ/√|K|; with corners off it
/// there are slightly larger ones, so that saddles make the estimate a little too high. The facets are the
/// integral over the area, the vertices half of them and χ: 2 + 1.209 r/δ on a sphere of radius r.
struct AsymptoticCount {
  double vertices = 0;
  double elliptic = 0, hyperbolic = 0; ///< ∫√|K| dA where K > 0, and where K < 0: lengths
};

/// Of a closed surface of triangles that agree and share their vertices, χ its Euler characteristic: K from
/// the angles at the vertices, averaged over patches about 2 δ wide. Nothing where the formula says nothing:
/// flat or ruled parts (more than a quarter of the area), edges and corners (more than a twentieth of the
/// area lies at edges that turn by more than 30°), triangles not finer than those of the optimum, or points
/// that χ does not fit, as they are not shared. The result depends on the arguments alone.
std::optional<AsymptoticCount> asymptotic_count(const TriangleSoup& surface, long euler_characteristic,
                                                double delta);

} // namespace isoscope
