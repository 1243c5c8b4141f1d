// Tilings: half-open boxes that fill space, exactly, wherever the origin is.
#include "tiles/tile_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace isoscope;

namespace {

const TileGrid grid(0.25, {{-3, -3, -3}, {5, 5, 5}});

/// Points here and there, some on the planes of tiles.
std::vector<Vec3> points() {
  std::vector<Vec3> all;
  std::uint64_t random = 7;
  const auto next = [&random] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    const double x = static_cast<double>(random >> 40) / (1 << 24) * 8 - 3;
    return random >> 33 & 1 ? x : std::floor(4 * x) / 4;
  };
  for (int i = 0; i < 2000; ++i) all.push_back({next(), next(), next()});
  return all;
}

} // namespace

TEST_CASE("Every point lies in the box of the tile of its brick, and in no other") {
  for (const Vec3 p : points())
    for (std::int32_t level = 0; level < 3; ++level)
      for (std::int32_t shift = 0; shift < shifts; ++shift) {
        const Tiling tiling{level, shift};
        const GridPlace tile = grid.tile_of(tiling, grid.brick_of(p));
        CHECK(grid.bounds(tiling, tile).holds(p));
        for (std::size_t a = 0; a < 3; ++a) {
          GridPlace other = tile;
          ++other[a];
          CHECK(!grid.bounds(tiling, other).holds(p));
        }
      }
}

TEST_CASE("Every point is an eighth of a tile away from the planes of one of four tilings") {
  for (const Vec3 p : points()) {
    double most = 0;
    for (std::int32_t shift = 0; shift < shifts; ++shift) {
      const Tiling tiling{1, shift};
      const ChangeBox box = grid.bounds(tiling, grid.tile_of(tiling, grid.brick_of(p)));
      double least = Box3::inf;
      for (int a = 0; a < 3; ++a) least = std::min({least, p[a] - box.lo[a], box.hi[a] - p[a]});
      most = std::max(most, least);
    }
    CHECK(most >= 2.0 / 8);
  }
}

TEST_CASE("A tile as large as the box is all of space") {
  const Box3 box{{-1, 0, 0}, {2, 1, 1}};
  const TileGrid coarse(largest_brick(box), box), fine(largest_brick(box) / 4, box);
  CHECK(coarse.is_whole(0));
  CHECK(!fine.is_whole(1));
  CHECK(fine.is_whole(2));
  CHECK(fine.bounds({2, 0, true}, {}).holds({1e9, -1e9, 0}));
  CHECK(fine.tile_of({2, 0, true}, {-7, 9, 3}) == GridPlace{});
}
