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

/// An edge of the subdivision that the surface crosses, by its low corner and where it leads (bits by axis).
struct CrossedEdge {
  unsigned low, direction;
  bool low_is_outer;
  unsigned inner() const { return low_is_outer ? low ^ direction : low; }
};

/// What a cube adds to the surface: its vertices on edges at corner 0, and what crossed triangles join.
struct Crossings {
  std::vector<CrossedEdge> vertices;
  std::vector<std::array<CrossedEdge, 2>> links;
};

/// By which corners are outside, a bit each.
inline std::vector<Crossings> crossings_by_outer_corners(const std::vector<Simplex>& simplices) {
  std::vector<Crossings> crossings(256);
  for (unsigned outer = 0; outer < crossings.size(); ++outer)
    for (const Simplex& s : simplices) {
      if (s.size > 3 || (s.mask & outer) == 0 || (s.mask & ~outer) == 0) continue;
      std::vector<CrossedEdge> ends;
      for (unsigned i = 0; i < s.size; ++i)
        for (unsigned j = i + 1; j < s.size; ++j) {
          const unsigned low = s.corners[i], high = s.corners[j];
          const bool low_is_outer = (outer >> low & 1u) != 0;
          if (low_is_outer != ((outer >> high & 1u) != 0)) ends.push_back({low, low ^ high, low_is_outer});
        }
      if (s.size == 2)
        crossings[outer].vertices.push_back(ends.front());
      else
        crossings[outer].links.push_back({ends[0], ends[1]});
    }
  return crossings;
}

} // namespace isoscope::kuhn
