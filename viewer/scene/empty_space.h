// How far a ray may go through the grid without meeting Ω.
#pragma once

#include "tolerance/distance_grid.h"

#include <array>
#include <vector>

namespace isoscope {

/// The grid in blocks of so many voxels a side, each with a margin of one voxel.
struct GridBlocks {
  std::array<int, 3> size{};
  int block = 1;
  std::vector<float> least; ///< the least φ/δ in the block; -1 where it holds a change of side
};
GridBlocks grid_blocks(const DistanceGrid& grid, int block);

/// By block: how far one may go from any point of it without meeting a voxel with φ <= level δ or a change of
/// side. Lengths in the unit of `voxel`.
std::vector<float> empty_space(const GridBlocks& blocks, float level, double voxel);

} // namespace isoscope
