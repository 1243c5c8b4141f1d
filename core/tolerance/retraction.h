// Whether Ω' shrinks onto the input, so that it has the input's topology (core/README.md, N7).
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"

#include <cstddef>

namespace isoscope {

/// Whether {d <= level} is proven to be a deformation of the triangles: no point of it off them is critical
/// for d, in the convex hull of its closest points [Grove 1993; Chazal and Lieutier 2005]. The triangles must
/// form a manifold, with or without border, by their corners, and meet in common edges and corners only.
/// False where that is not so, as where d <= level closes something, or where it takes more than about
/// `most_cells` to tell. The same on any number of threads.
bool shrinks_onto_triangles(const ClosestPointIndex& index, double level, std::size_t most_cells,
                            const RunControl& control);

} // namespace isoscope
