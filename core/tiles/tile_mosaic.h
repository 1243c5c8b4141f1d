// What there is to see of a folder of tiles: bricks, Z as far as it is made, and what is frozen in it.
#pragma once

#include "base/run_control.h"
#include "tiles/tile_folder.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// A brick in which facets of Z begin.
struct MosaicBrick {
  GridPlace place{};
  std::uint32_t tile = 0;   ///< into the round's list
  std::uint64_t facets = 0; ///< that begin there
};

struct TileMosaic {
  double brick = 0; ///< side
  std::vector<MosaicBrick> bricks;
  /// Z: of tiles that are made what they have left, of others what they begin with. Empty where it is too
  /// large; then bricks are those before the round.
  std::vector<Triangle3> facets;
  std::vector<std::uint32_t> tile_of_facet; ///< by facet, into the round's list
  /// Vertices of Z with a facet that crosses a wall between tiles: the round leaves them where they are.
  std::vector<Vec3> frozen;
  std::uint64_t facet_count = 0;
};

/// Of a round that was begun. `most_facets`: of a Z whose facets are kept. Fails with io, bad_input, or
/// cancelled.
Result<TileMosaic> mosaic_of(const TileFolder& folder, const TileRound& round, std::uint64_t most_facets,
                             const RunControl& control);

/// Where a brick lies.
Box3 bounds_of(const GridPlace& brick, double side);

} // namespace isoscope
