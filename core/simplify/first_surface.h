// The first Z where none has to be refined: a surface inside Ω that is known already.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "tolerance/tolerance_volume.h"

namespace isoscope {

/// Whether the input itself can be the first Z: a closed manifold that is free of intersections by exact
/// predicates, and whose every wall lies between inside and outside. Fails with usage, naming the place.
Status can_start_from_input(const ToleranceVolume& volume);
/// The input as Z: points of equal coordinates merged, in ascending order, turned to the outside. For a
/// volume that passed can_start_from_input().
TriangleMesh surface_of_input(const ToleranceVolume& volume);

} // namespace isoscope
