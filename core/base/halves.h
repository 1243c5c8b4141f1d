// How pieces of the input are cut in two where a search has to look more closely.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstddef>

namespace isoscope {

/// The longest edge of a triangle, by its first corner: of equal ones the first.
inline std::size_t longest_edge_of(const Triangle3& t) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (distance(t[i], t[(i + 1) % 3]) > distance(t[longest], t[(longest + 1) % 3])) longest = i;
  return longest;
}

/// The two parts of a triangle on both sides of the middle of its longest edge.
inline std::array<Triangle3, 2> halves(const Triangle3& t) {
  const std::size_t longest = longest_edge_of(t), next = (longest + 1) % 3;
  std::array<Triangle3, 2> parts{t, t};
  parts[0][longest] = parts[1][next] = 0.5 * (t[longest] + t[next]);
  return parts;
}

} // namespace isoscope
