// The simplices of a cube's subdivision into six tetrahedra, and what χ of a surface through it they tell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope::kuhn {

/// The simplices of Kuhn's subdivision of a cube that hold its corner 0, as corner numbers. Over all cubes
/// they are all simplices of the lattice, each once. Crossed by the surface they become its vertices, edges
/// and faces.
struct Simplex {
  std::array<unsigned, 4> corners;
  unsigned size;
  int sign;
  unsigned mask; ///< a bit for each corner
};

inline std::vector<Simplex> simplices_at_corner() {
  std::vector<Simplex> list;
  for (unsigned a = 1; a < 8; ++a) list.push_back({{0, a, 0, 0}, 2, 1, 0});
  for (unsigned b = 1; b < 8; ++b)
    for (unsigned a = 1; a < b; ++a)
      if ((a & b) == a) list.push_back({{0, a, b, 0}, 3, -1, 0});
  for (unsigned first = 1; first < 8; first <<= 1)
    for (unsigned second = 1; second < 8; second <<= 1)
      if (first != second) list.push_back({{0, first, first | second, 7}, 4, 1, 0});
  for (Simplex& s : list)
    for (unsigned i = 0; i < s.size; ++i) s.mask |= 1u << s.corners[i];
  return list;
}

/// What a cube adds to χ by which of its corners are outside, a bit each.
inline std::array<std::int8_t, 256> euler_by_outer_corners(const std::vector<Simplex>& simplices) {
  std::array<std::int8_t, 256> euler{};
  for (unsigned outer = 0; outer < euler.size(); ++outer)
    for (const Simplex& s : simplices) {
      unsigned count = 0;
      for (unsigned i = 0; i < s.size; ++i) count += outer >> s.corners[i] & 1u;
      if (count > 0 && count < s.size) euler[outer] = static_cast<std::int8_t>(euler[outer] + s.sign);
    }
  return euler;
}

} // namespace isoscope::kuhn
