// The curves of Z as it is drawn: its border, where three sheets or more meet, and the points where curves do
// (§4.1, §4.2).
#pragma once

#include "mesh/zero_set.h"

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace isoscope {

/// By vertices of a ZeroSet.
struct ZeroCurves {
  using Edge = std::array<std::uint32_t, 2>;
  std::vector<Edge> border; ///< edges with one polygon, as it runs; ascending
  std::vector<Edge> triple; ///< edges with three or more, the smaller end first; ascending
  /// Where not two of these edges meet: curves end, branch or cross; ascending.
  std::vector<std::uint32_t> points;
  bool empty() const { return border.empty() && triple.empty(); }
};

/// Of Z in any of its forms. A closed surface with one inside has none, which is told at once.
ZeroCurves zero_curves(const ZeroSet& zero_set);

/// A facet of an embedded T between two sides that is no part of Z: its tetrahedron on the side of the larger
/// label, and the vertex opposite to it there.
struct DroppedFacet {
  TetId tet;
  std::uint8_t facet = 0;
  friend auto operator<=>(const DroppedFacet&, const DroppedFacet&) = default;
};
/// What was cut off along the rim (§4.1), ascending; nothing unless Z is embedded.
std::vector<DroppedFacet> dropped_facets(const Complex& complex);

} // namespace isoscope
