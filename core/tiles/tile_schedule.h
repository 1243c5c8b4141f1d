// Which round follows: four shifts again, larger tiles, or none.
#pragma once

#include "tiles/tile_folder.h"

#include <optional>
#include <vector>

namespace isoscope {

/// What a facet of Z and a triangle of the input take while a tile is improved, bytes.
constexpr double bytes_of_tile_facet = 500, bytes_of_tile_triangle = 200;

/// Z and the input by brick: how many facets begin there.
struct BrickLoad {
  GridPlace brick{};
  std::uint64_t facets = 0, triangles = 0;
};

/// Bytes that the heaviest tile of a level takes, in any of its shifts.
double heaviest_tile(const TileGrid& grid, std::int32_t level, const std::vector<BrickLoad>& loads);
/// The brick, a power of two, whose tiles of four bricks a side take no more than `memory`, as large as can
/// be; not below `least`.
double fitting_brick(const Box3& box, double memory, double least, const std::vector<Triangle3>& z,
                     const std::vector<Triangle3>& input);

/// What follows the rounds that are complete; nothing where no further one is worthwhile. A level ends when
/// its four shifts have taken little away; tiles double as long as they fit, with effort 1 below the last
/// level.
struct NextRound {
  Tiling tiling;
  int effort = 1;
};
std::optional<NextRound> next_round(const TileGrid& grid, const std::vector<TileRound>& complete,
                                    std::uint64_t facets, int effort, double memory,
                                    const std::vector<BrickLoad>& loads);

} // namespace isoscope
