// Which places of the distance grid a ray has to look at, and how far it may go otherwise.
#pragma once

#include "tolerance/distance_grid.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// By brick: the least φ/δ in it; -1 where it holds a change of side.
std::vector<float> least_in_bricks(const DistanceGrid& grid);

/// What the shaders read of a place: a brick's number with this bit, or how many places around it, itself
/// included, a ray may cross in any direction.
constexpr std::uint32_t full_place = 0x80000000u;

/// By place; bricks whose least value is above the level count as empty.
std::vector<std::uint32_t> place_entries(const DistanceGrid& grid, const std::vector<float>& least,
                                         float level);

} // namespace isoscope
