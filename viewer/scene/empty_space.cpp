// How far a ray may go through the grid without meeting Ω.
#include "scene/empty_space.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// Of the block, grown by a voxel all round.
float least_in(const DistanceGrid& grid, std::array<int, 3> from, int block) {
  bool positive = false, negative = false;
  float least = grid.clamp;
  std::array<int, 3> lo{}, hi{};
  for (std::size_t i = 0; i < 3; ++i) {
    lo[i] = std::max(from[i] - 1, 0);
    hi[i] = std::min(from[i] + block + 1, grid.size[i]);
  }
  for (int z = lo[2]; z < hi[2]; ++z)
    for (int y = lo[1]; y < hi[1]; ++y)
      for (int x = lo[0]; x < hi[0]; ++x) {
        const std::size_t i = (static_cast<std::size_t>(z) * grid.size[1] + y) * grid.size[0] + x;
        least = std::min(least, grid.values[i]);
        (grid.sides.empty() || grid.sides[i] > 0 ? positive : negative) = true;
      }
  return positive && negative ? -1.0f : least;
}

} // namespace

GridBlocks grid_blocks(const DistanceGrid& grid, int block) {
  GridBlocks blocks;
  blocks.block = block;
  for (std::size_t i = 0; i < 3; ++i) blocks.size[i] = (grid.size[i] + block - 1) / block;
  const auto row = static_cast<std::size_t>(blocks.size[0]),
             slice = row * static_cast<std::size_t>(blocks.size[1]);
  blocks.least.resize(slice * static_cast<std::size_t>(blocks.size[2]));
  parallel_for(blocks.least.size(), 64, [&](std::size_t i) {
    const std::array<int, 3> at{static_cast<int>(i % row), static_cast<int>(i % slice / row),
                                static_cast<int>(i / slice)};
    blocks.least[i] = least_in(grid, {at[0] * block, at[1] * block, at[2] * block}, block);
  });
  return blocks;
}

std::vector<float> empty_space(const GridBlocks& blocks, float level, double voxel) {
  const std::array<int, 3>& size = blocks.size;
  const auto index = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * size[1] + y) * size[0] + x;
  };
  // Chebyshev distance to the nearest occupied block by a forward and a backward sweep.
  const int far_away = size[0] + size[1] + size[2];
  std::vector<int> steps(static_cast<std::size_t>(size[0]) * size[1] * size[2], far_away);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (blocks.least[i] <= level) steps[i] = 0;
  const auto relax = [&](int x, int y, int z, int direction) {
    int& here = steps[index(x, y, z)];
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if ((dz * 9 + dy * 3 + dx) * direction >= 0) continue;
          const int nx = x + dx, ny = y + dy, nz = z + dz;
          if (nx < 0 || ny < 0 || nz < 0 || nx >= size[0] || ny >= size[1] || nz >= size[2]) continue;
          here = std::min(here, steps[index(nx, ny, nz)] + 1);
        }
  };
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) relax(x, y, z, 1);
  for (int z = size[2] - 1; z >= 0; --z)
    for (int y = size[1] - 1; y >= 0; --y)
      for (int x = size[0] - 1; x >= 0; --x) relax(x, y, z, -1);
  std::vector<float> jump(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    jump[i] = static_cast<float>(std::max(0, steps[i] - 1) * blocks.block * voxel);
  return jump;
}

} // namespace isoscope
