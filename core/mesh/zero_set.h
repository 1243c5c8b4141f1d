// Z, Γ and ∂Γ of a triangulation: polygons per tetrahedron, components, Euler characteristics (§2.3, Figure
// 5).
#pragma once

#include "input/triangle_soup.h"
#include "mesh/complex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// The zero set of f: one triangle or quad per tetrahedron that carries it, several triangles where it has
/// three labels or more, or the facets that form it once it is embedded or free.
struct ZeroSet {
  struct ZeroVertex {
    Vec3 position;
    /// The ends of the edge of T it lies on, that of the smaller label first; both the vertex itself where
    /// F = 0. Of a junction: corners of its facet or tetrahedron.
    VertexId negative, positive;
    bool junction = false; ///< inside a facet or tetrahedron of three labels or more (§4.2)
  };
  struct Polygon {
    TetId tet; ///< that carries it; embedded: the one on the side of its larger label; free: invalid
    std::array<std::uint32_t, 4> v; ///< counter-clockwise seen from the larger of its labels
    std::uint8_t count = 3;         ///< 3 or 4
    std::uint32_t component = 0;
    FacetId facet;            ///< its slot when Z is free, else invalid
    LabelPair labels{+1, -1}; ///< what it lies between
  };
  struct Component {
    std::size_t vertices = 0, edges = 0, polygons = 0;
    std::size_t loops = 0; ///< closed curves of its border: those of edges with one polygon
    long euler_characteristic() const {
      return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(polygons);
    }
    long genus() const { return (2 - euler_characteristic() - static_cast<long>(loops)) / 2; }
  };
  std::vector<ZeroVertex> vertices;
  std::vector<Polygon> polygons;     ///< ascending by tetrahedron or facet slot
  std::vector<Component> components; ///< by smallest tetrahedron slot
  long euler_characteristic() const;
  std::size_t boundary_loops() const;
  /// Whether there is more than one inside.
  bool has_rooms() const;
};

/// The zero polygon of one positively oriented tetrahedron: its corners in order (3 or 4), counter-clockwise
/// from the positive side. Corner n + w (p − n), w = f(n) / (f(n) − f(p)), from the negative to the positive
/// end: the same bits from every tetrahedron on the edge, exact for values ±1 and 2^k − 1 on grid points. A
/// vertex with f = 0 leaves no polygon.
struct ZeroPolygon {
  std::array<Vec3, 4> corner;
  std::array<std::array<std::uint8_t, 2>, 4>
      edge;      ///< local indices (negative, positive) of the edge each corner lies on
  int count = 0; ///< 0 when homogeneous, or where some f = 0
};
ZeroPolygon zero_polygon(const std::array<Vec3, 4>& p, const std::array<double, 4>& f);

/// The triangles of a polygon of 3 or 4 corners as indices into them, in its orientation: a quad is split
/// along its shorter diagonal, along that of corner 0 when both are equal.
struct PolygonSplit {
  std::array<std::array<std::uint8_t, 3>, 2> triangles{};
  std::size_t count = 0; ///< 1 or 2; 0 for a polygon without corners
};
PolygonSplit split_polygon(const std::array<Vec3, 4>& corner, int count);

/// Z of the whole triangulation.
ZeroSet extract_zero_set(const Complex& complex);
/// Z as an oriented triangle mesh, quads split along their shorter diagonal; outward is the side of the
/// larger label. With the labels of each triangle where there is more than one inside.
TriangleMesh triangulate(const ZeroSet& zero_set);

/// A facet of ∂Γ: between a tetrahedron of Γ (Complex::in_gamma) and one that is not (or the hull). `tet` is
/// in Γ; `v` is counter-clockwise seen from outside of it.
struct GammaFacet {
  TetId tet;
  std::array<VertexId, 3> v;
};
/// ∂Γ, ascending by tetrahedron slot and facet.
std::vector<GammaFacet> gamma_boundary(const Complex& complex);

} // namespace isoscope
