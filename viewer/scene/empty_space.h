// Which places of the distance grid a ray has to look at, and how far it may go otherwise.
#pragma once

#include "tolerance/distance_grid.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// By brick: the least φ/δ in it; -1 where it holds a change of side.
std::vector<float> least_in_bricks(const DistanceGrid& grid);

/// What the shaders read of a place: where its brick is (BrickAtlas::packed), and above that how many places
/// around it, itself included, a ray may cross in any direction; 0 where it may meet Ω.
constexpr unsigned brick_bits = 24;
/// A place that a ray may meet Ω in.
constexpr bool is_full(std::uint32_t entry) {
  return entry >> brick_bits == 0;
}

/// By place; bricks whose least value is above the level need not be looked at. A place without a brick has
/// one of one value.
std::vector<std::uint32_t> place_entries(const DistanceGrid& grid, const std::vector<float>& least,
                                         float level);

} // namespace isoscope
