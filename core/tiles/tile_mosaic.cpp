// Files of tiles that are made, and the rest from the round before.
#include "tiles/tile_mosaic.h"

#include "base/point_order.h"

#include <algorithm>
#include <map>
#include <set>

namespace isoscope {
namespace {

/// The bricks of what a round begins with, from the heads of its files.
Result<std::map<GridPlace, std::uint64_t>> bricks_before(const TileFolder& folder, std::uint32_t round) {
  std::map<GridPlace, std::uint64_t> bricks;
  std::error_code failed;
  const auto files = folder.output(round - 1, {}).parent_path();
  for (const auto& file : std::filesystem::directory_iterator(files, failed)) {
    if (file.path().extension() != ".facets") continue;
    const auto entries = read_bricks(file.path());
    if (!entries) return entries.error();
    for (const BrickEntry& e : *entries) bricks[e.brick] += e.count;
  }
  return bricks;
}

/// Vertices of facets that are not wholly in the box of one tile.
std::vector<Vec3> frozen_vertices(const TileMosaic& mosaic, const TileGrid& grid, const Tiling& tiling) {
  std::vector<Vec3> frozen;
  for (const Triangle3& f : mosaic.facets) {
    const auto tile = [&](Vec3 p) { return grid.tile_of(tiling, grid.brick_of(p)); };
    if (tile(f[0]) == tile(f[1]) && tile(f[0]) == tile(f[2])) continue;
    frozen.insert(frozen.end(), f.begin(), f.end());
  }
  std::sort(frozen.begin(), frozen.end(), lies_before);
  frozen.erase(std::unique(frozen.begin(), frozen.end()), frozen.end());
  return frozen;
}

} // namespace

Result<TileMosaic> mosaic_of(const TileFolder& folder, const TileRound& round, std::uint64_t most_facets,
                             const RunControl& control) {
  const TileGrid grid = folder.grid();
  TileMosaic mosaic;
  mosaic.brick = grid.brick();
  mosaic.facet_count = round.facets;
  std::map<GridPlace, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < round.tiles.size(); ++i) numbers[round.tiles[i].tile] = i;
  const auto number_of = [&](const GridPlace& brick) {
    const auto at = numbers.find(grid.tile_of(round.tiling, brick));
    return at != numbers.end() ? at->second : 0;
  };
  std::map<GridPlace, std::uint64_t> bricks;
  if (round.facets > most_facets) {
    auto before = bricks_before(folder, round.number);
    if (!before) return before.error();
    bricks = std::move(*before);
  } else {
    auto facets = folder.z_before(round.number, all_of_space);
    if (!facets) return facets.error();
    const std::vector<std::size_t> pending = folder.pending(round);
    std::set<std::uint32_t> waits(pending.begin(), pending.end());
    const auto brick_of = [&](const Triangle3& f) { return grid.brick_of(canonical(f)[0]); };
    std::erase_if(*facets, [&](const Triangle3& f) { return !waits.contains(number_of(brick_of(f))); });
    for (std::uint32_t i = 0; i < round.tiles.size(); ++i) {
      if (control.cancelled()) return Error{ErrorCode::cancelled, "Nobody looks any more.", ""};
      if (waits.contains(i)) continue;
      const auto file = folder.output(round.number, round.tiles[i].tile);
      if (Status read = read_facets(file, all_of_space, *facets); !read) return read.error();
    }
    for (const Triangle3& f : *facets) {
      const GridPlace brick = brick_of(f);
      ++bricks[brick];
      mosaic.tile_of_facet.push_back(number_of(brick));
    }
    mosaic.facets = std::move(*facets);
    mosaic.facet_count = mosaic.facets.size();
    if (!round.tiling.whole) mosaic.frozen = frozen_vertices(mosaic, grid, round.tiling);
  }
  for (const auto& [place, facets] : bricks) mosaic.bricks.push_back({place, number_of(place), facets});
  return mosaic;
}

Box3 bounds_of(const GridPlace& brick, double side) {
  const Vec3 low{side * brick[0], side * brick[1], side * brick[2]};
  return {low, low + Vec3{side, side, side}};
}

} // namespace isoscope
