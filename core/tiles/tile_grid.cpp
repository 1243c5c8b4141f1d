// Whole numbers of bricks; floors are exact as sides are powers of two.
#include "tiles/tile_grid.h"

#include <cmath>
#include <limits>

namespace isoscope {
GridPlace TileGrid::brick_of(Vec3 p) const {
  GridPlace at{};
  for (int a = 0; a < 3; ++a)
    at[static_cast<std::size_t>(a)] = static_cast<std::int32_t>(std::floor(p[a] / brick_));
  return at;
}

GridPlace TileGrid::tile_of(const Tiling& tiling, const GridPlace& brick) const {
  if (tiling.whole) return {};
  const std::int32_t step = 1 << tiling.level;
  GridPlace at{};
  for (std::size_t a = 0; a < 3; ++a)
    at[a] = floor_div(brick[a] - tiling.shift * step, bricks_of_tile * step);
  return at;
}

ChangeBox TileGrid::bounds(const Tiling& tiling, const GridPlace& tile) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (tiling.whole) return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  const std::int32_t step = 1 << tiling.level;
  ChangeBox box;
  for (int a = 0; a < 3; ++a) {
    const std::int32_t first =
        tile[static_cast<std::size_t>(a)] * bricks_of_tile * step + tiling.shift * step;
    box.lo[a] = first * brick_;
    box.hi[a] = (first + bricks_of_tile * step) * brick_;
  }
  return box;
}

bool TileGrid::is_whole(std::int32_t level) const {
  return std::ldexp(bricks_of_tile * brick_, level) >= box_.longest_edge();
}

double largest_brick(const Box3& box) {
  return std::exp2(std::ceil(std::log2(box.longest_edge() / bricks_of_tile)));
}

} // namespace isoscope
