// Points that Z keeps on their side in tiles: of regions deeper than δ, and of what is thinner than that.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tiles/tile_folder.h"

#include <optional>
#include <vector>

namespace isoscope {

struct TileAnchors {
  /// Of {d > δ}: one in every component, as witnesses_of_piece() finds them, some in more than one tile.
  std::vector<Vec3> witnesses;
  /// Of walls and gaps where nothing is that deep, so that with those each point of the input has a point of
  /// each side within `cover`: Z passes between them.
  std::vector<Vec3> held;
};

/// Of the input that a folder has, which is closed and free of intersections, tile by tile of the first
/// tiling, from its files. `cover` is absolute; below 2 δ, and without it, no points are held. Fails with io,
/// bad_input, cancelled, and as witnesses_of_piece().
Result<TileAnchors> find_anchors(const TileFolder& folder, std::optional<double> cover,
                                 const RunControl& control);

} // namespace isoscope
