// Z where three labels or more meet in a tetrahedron: its zeros joined to a point in each facet of three
// labels and to one inside (§4.2).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// The zero between n and p, for f < 0 at n and f > 0 at p: always in this order, so that every tetrahedron
/// gets the same bits.
constexpr Vec3 zero_point(Vec3 n, double f_negative, Vec3 p, double f_positive) {
  return n + (f_negative / (f_negative - f_positive)) * (p - n);
}

/// Z inside one tetrahedron: a cone over what it has on the tetrahedron's facets. No label weighs more than
/// half on what bounds its part, so that f_i > 0 keeps a point on the side i.
struct Junction {
  /// Corners by number: zeros on edges, means of a facet's zeros by the vertex opposite, the mean of all.
  static constexpr std::uint8_t first_facet = 6, center_corner = 10;
  /// A triangle of Z, counter-clockwise seen from the larger of its labels.
  struct Facet {
    std::array<std::uint8_t, 3> corner;
    LabelPair labels;
  };
  std::array<Vec3, 11> position;
  std::array<Facet, 12> facets;
  std::size_t count = 0;

  Vec3 center() const { return position[center_corner]; }
  /// Local ends of the edge that a corner below first_facet lies on.
  static std::array<std::uint8_t, 2> edge(std::uint8_t corner);
};

/// Of a positively oriented tetrahedron with three labels or four, none of them 0. `v` numbers its corners:
/// sums are taken in that order, so that tetrahedra agree on their common facets to the last bit.
Junction make_junction(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                       const TetLabels& labels, const std::array<VertexId, 4>& v);

/// A triangle of Z and the labels that it lies between.
struct LabelledTriangle {
  Triangle3 corners;
  LabelPair labels;
};
/// Z of a positively oriented tetrahedron of any labels, as the mesh has it; none where a corner is on Z.
void append_zero_triangles(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                           const TetLabels& labels, const std::array<VertexId, 4>& v,
                           std::vector<LabelledTriangle>& out);

} // namespace isoscope
