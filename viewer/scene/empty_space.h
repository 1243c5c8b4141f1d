// How far a ray may go through the grid without meeting Ω.
#pragma once

#include "tolerance/distance_grid.h"

#include <array>
#include <vector>

namespace isoscope {

/// For blocks of `block` voxels a side: how far one may go from any point of a block without meeting a voxel
/// with d <= δ or a change of side. `size` is that of the result; lengths in the unit of `voxel`.
std::vector<float> empty_space(const DistanceGrid& grid, int block, double voxel, std::array<int, 3>& size);

} // namespace isoscope
