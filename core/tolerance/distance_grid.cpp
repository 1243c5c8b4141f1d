// Fills the grid block by block; blocks far from the input cost one query.
#include "tolerance/distance_grid.h"

#include "base/parallel.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr int block_side = 4;

struct BlockRange {
  std::array<int, 3> begin, end;
};

BlockRange block_range(std::size_t block, const std::array<int, 3>& blocks, const std::array<int, 3>& size) {
  const auto b = static_cast<int>(block);
  const std::array<int, 3> at{b % blocks[0], b / blocks[0] % blocks[1], b / (blocks[0] * blocks[1])};
  BlockRange range{};
  for (std::size_t a = 0; a < 3; ++a) {
    range.begin[a] = at[a] * block_side;
    range.end[a] = std::min(range.begin[a] + block_side, size[a]);
  }
  return range;
}

} // namespace

Result<DistanceGrid> make_distance_grid(const ToleranceField& field, double delta, int resolution,
                                        const RunControl& control, double margin) {
  if (!(delta > 0) || resolution < 1)
    return Error{ErrorCode::usage, "A distance grid needs a tolerance and a size.", ""};
  DistanceGrid grid;
  grid.box = field.bounds().grown(margin * delta);
  const double voxel = grid.box.longest_edge() / resolution;
  std::array<int, 3> blocks{};
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    grid.size[axis] =
        std::clamp(static_cast<int>(std::ceil(grid.box.extent()[a] / voxel - 1e-9)), 1, resolution);
    grid.box.hi[a] = grid.box.lo[a] + voxel * grid.size[axis];
    blocks[axis] = (grid.size[axis] + block_side - 1) / block_side;
  }
  const auto row = static_cast<std::size_t>(grid.size[0]),
             slice = row * static_cast<std::size_t>(grid.size[1]);
  grid.values.assign(slice * static_cast<std::size_t>(grid.size[2]), grid.clamp);
  const double reach = grid.clamp * delta;
  const auto center = [&](double x, double y, double z) {
    return grid.box.lo + voxel * Vec3{x + 0.5, y + 0.5, z + 0.5};
  };
  const auto fill = [&](std::size_t block) {
    const BlockRange r = block_range(block, blocks, grid.size);
    const Vec3 middle = center(0.5 * (r.begin[0] + r.end[0] - 1), 0.5 * (r.begin[1] + r.end[1] - 1),
                               0.5 * (r.begin[2] + r.end[2] - 1));
    const double radius = 0.5 * std::sqrt(3.0) * (block_side - 1) * voxel;
    ClosestPoint last = field.closest_within(middle, (reach + radius) * (1 + 1e-9));
    if (!last.triangle.valid()) return; // φ is 1-Lipschitz: the whole block is beyond the clamp
    for (int z = r.begin[2]; z < r.end[2]; ++z)
      for (int y = r.begin[1]; y < r.end[1]; ++y)
        for (int x = r.begin[0]; x < r.end[0]; ++x) {
          last = field.closest_near(center(x, y, z), last.triangle);
          const std::size_t i = static_cast<std::size_t>(z) * slice + static_cast<std::size_t>(y) * row +
                                static_cast<std::size_t>(x);
          grid.values[i] = std::min(grid.clamp, static_cast<float>(last.distance() / delta));
        }
  };
  const auto count = static_cast<std::size_t>(blocks[0]) * static_cast<std::size_t>(blocks[1]) *
                     static_cast<std::size_t>(blocks[2]);
  parallel_until(count, 16, control, fill);
  if (control.cancelled()) return Error{ErrorCode::cancelled, "Stopped while computing distances.", ""};
  return grid;
}

} // namespace isoscope
