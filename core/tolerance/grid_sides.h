// On which side each voxel of a distance grid lies, so that a picture tells the two boundaries of Ω apart.
#pragma once

#include "tolerance/distance_grid.h"
#include "tolerance/tolerance_volume.h"

#include <span>

namespace isoscope {

/// Fills grid.sides. A side spreads from outside the input's bounding box (+1) and from the regions' deepest
/// points (their labels) between neighbouring voxels whose distances prove that the input does not pass
/// between their centres; where nothing proves it, `sides` decides. Without a surface it spreads outside of
/// Ω', and from there to the nearest voxels. Fails with cancelled when told to.
Status find_sides(DistanceGrid& grid, const ToleranceField& field, const InputSides& sides, double delta,
                  std::span<const Region> regions, const RunControl& control);

} // namespace isoscope
