// Bundled models that give a tolerance volume instead of a surface.
#pragma once

#include "input/triangle_soup.h"

namespace isoscope {

/// The levels of make_density(), between which its ring of six beads is whole.
constexpr double density_low = 0.25, density_high = 0.5;

/// A torus and, inside of it, a thinner one that is not in its middle: two walls.
TriangleSoup make_nested_tori();

/// A grid: the density of six round beads that run into each other along a ring. With triangles of both
/// levels.
TriangleSoup make_density();

} // namespace isoscope
