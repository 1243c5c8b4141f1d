// Which round follows: four shifts again, larger tiles, or none.
#pragma once

#include "tiles/tile_folder.h"

#include <map>
#include <optional>
#include <vector>

namespace isoscope {

/// What a facet of Z and a triangle of the input take at most while a tile is cut, improved or proven, bytes.
/// Together 0.96 kB were measured where facets are as large as δ, and 0.4 kB where they are much smaller and
/// go at once.
constexpr double bytes_of_tile_facet = 730, bytes_of_tile_triangle = 260;

/// Bytes that the heaviest tile of a level takes, in any of its shifts.
double heaviest_tile(const TileGrid& grid, std::int32_t level, const std::vector<BrickLoad>& loads);
/// The tiles in which anything of the bricks' facets may lie, ascending.
std::vector<GridPlace> tiles_met(const TileGrid& grid, const Tiling& tiling,
                                 const std::vector<BrickLoad>& loads);
/// Counts what begins where, in bricks so fine that those of any grid that may be taken can be told.
class BrickCounts {
 public:
  /// `least`: side of the smallest brick that may be.
  BrickCounts(const Box3& box, double least);
  /// Of the brick that holds a facet's lowest vertex.
  BrickLoad& at(Vec3 lowest) { return bricks_[finest_.brick_of(lowest)]; }
  /// The brick, a power of two, whose tiles of four bricks a side take no more than `memory`, as large as can
  /// be.
  double fitting_brick(double memory) const;

 private:
  TileGrid finest_;
  std::map<GridPlace, BrickLoad> bricks_;
};

/// What follows the rounds that are complete; nothing where no further one is worthwhile. Tiles double after
/// four shifts as long as they fit, with effort 1 below the last level, which ends when its four shifts have
/// taken little away.
struct NextRound {
  Tiling tiling;
  int effort = 1;
};
std::optional<NextRound> next_round(const TileGrid& grid, const std::vector<TileRound>& complete,
                                    std::uint64_t facets, int effort, double memory,
                                    const std::vector<BrickLoad>& loads);

} // namespace isoscope
