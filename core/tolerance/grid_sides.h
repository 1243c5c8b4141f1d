// On which side each sample of a distance grid lies, so that a picture tells the two boundaries of Ω apart.
#pragma once

#include "tolerance/coarse_sides.h"
#include "tolerance/distance_grid.h"

namespace isoscope {

/// Gives the grid's values and its empty places their signs. Sides come from a coarse lattice; from there
/// they spread within bricks and to neighbouring ones as far as distances prove that the input does not pass
/// between samples; where nothing proves it, `input.sides` decides. Without a surface they spread outside of
/// Ω', and from there to the nearest samples. Fails with cancelled when told to.
Status find_sides(DistanceGrid& grid, const SidedInput& input, const RunControl& control);

} // namespace isoscope
