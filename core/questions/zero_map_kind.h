// What Z can be coloured by.
#pragma once

#include <cstdint>

namespace isoscope {

enum class ZeroMapKind : std::uint8_t {
  none,
  distance, ///< φ/δ: how much of the tolerance is used
  normals,  ///< the angle to the input's normal, degrees
  valence,  ///< edges of Z at a vertex
  age       ///< steps since a facet was made or moved
};
constexpr int zero_map_count = static_cast<int>(ZeroMapKind::age) + 1;

} // namespace isoscope
