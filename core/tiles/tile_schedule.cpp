// Sums the bricks of each tile; the rest follows from the rounds so far.
#include "tiles/tile_schedule.h"

#include <algorithm>
#include <map>
#include <set>

namespace isoscope {
namespace {

/// Below this share of its facets four rounds are the last of the last level.
constexpr double worthwhile = 0.01;
/// From the largest brick to the finest.
constexpr int most_halvings = 8;
/// Of what lies around a tile and is read with it.
constexpr double surroundings = 1.3;

Tiling tiling_of(const TileGrid& grid, std::int32_t level) {
  return {level, 0, grid.is_whole(level)};
}

NextRound begin_level(const TileGrid& grid, std::int32_t level, int effort, double memory,
                      const std::vector<BrickLoad>& loads) {
  const bool last = grid.is_whole(level) || heaviest_tile(grid, level + 1, loads) > memory;
  return {tiling_of(grid, level), last ? effort : std::min(effort, 1)};
}

} // namespace

double heaviest_tile(const TileGrid& grid, std::int32_t level, const std::vector<BrickLoad>& loads) {
  Tiling tiling = tiling_of(grid, level);
  double heaviest = 0;
  for (tiling.shift = 0; tiling.shift < (tiling.whole ? 1 : shifts); ++tiling.shift) {
    std::map<GridPlace, double> tiles;
    for (const BrickLoad& load : loads)
      tiles[grid.tile_of(tiling, load.brick)] +=
          surroundings * (bytes_of_tile_facet * static_cast<double>(load.facets) +
                          bytes_of_tile_triangle * static_cast<double>(load.triangles));
    for (const auto& [tile, bytes] : tiles) heaviest = std::max(heaviest, bytes);
  }
  return heaviest;
}

std::vector<GridPlace> tiles_met(const TileGrid& grid, const Tiling& tiling,
                                 const std::vector<BrickLoad>& loads) {
  std::set<GridPlace> tiles;
  for (const BrickLoad& load : loads) {
    const GridPlace lo = grid.tile_of(tiling, grid.brick_of(load.box.lo));
    const GridPlace hi = grid.tile_of(tiling, grid.brick_of(load.box.hi));
    for (GridPlace at = lo; at[0] <= hi[0]; ++at[0])
      for (at[1] = lo[1]; at[1] <= hi[1]; ++at[1])
        for (at[2] = lo[2]; at[2] <= hi[2]; ++at[2]) tiles.insert(at);
  }
  return {tiles.begin(), tiles.end()};
}

BrickCounts::BrickCounts(const Box3& box, double least) : finest_(largest_brick(box), box) {
  for (int depth = 0; depth < most_halvings && finest_.brick() / 2 >= least; ++depth)
    finest_ = TileGrid(finest_.brick() / 2, box);
}

double BrickCounts::fitting_brick(double memory) const {
  double brick = largest_brick(finest_.box());
  for (; brick > finest_.brick(); brick /= 2) {
    const auto share = static_cast<std::int32_t>(brick / finest_.brick());
    std::map<GridPlace, BrickLoad> coarse;
    for (const auto& [place, load] : bricks_) {
      BrickLoad& sum =
          coarse[{floor_div(place[0], share), floor_div(place[1], share), floor_div(place[2], share)}];
      sum.facets += load.facets;
      sum.triangles += load.triangles;
    }
    std::vector<BrickLoad> loads;
    for (auto& [place, load] : coarse) {
      load.brick = place;
      loads.push_back(load);
    }
    if (heaviest_tile(TileGrid(brick, finest_.box()), 0, loads) <= memory) break;
  }
  return brick;
}

std::optional<NextRound> next_round(const TileGrid& grid, const std::vector<TileRound>& complete,
                                    std::uint64_t facets, int effort, double memory,
                                    const std::vector<BrickLoad>& loads) {
  if (complete.empty()) return begin_level(grid, 0, effort, memory, loads);
  const TileRound& last = complete.back();
  if (last.tiling.whole) return std::nullopt;
  if (last.tiling.shift + 1 < shifts) {
    NextRound next{last.tiling, last.effort};
    ++next.tiling.shift;
    return next;
  }
  if (heaviest_tile(grid, last.tiling.level + 1, loads) <= memory)
    return begin_level(grid, last.tiling.level + 1, effort, memory, loads);
  const auto before = static_cast<double>(complete[complete.size() - shifts].facets);
  const double gain = before > 0 ? 1 - static_cast<double>(facets) / before : 0;
  const NextRound again{{last.tiling.level, 0, false}, last.effort};
  if (gain >= worthwhile) return again;
  if (last.effort < effort) return NextRound{again.tiling, effort};
  return std::nullopt;
}

} // namespace isoscope
