// Delaunay insertion into T: CGAL finds the conflict zone, we get a delta with stable slots.
#pragma once

#include "mesh/complex.h"

#include <memory>
#include <span>

namespace isoscope {

/// Incremental 3D Delaunay triangulation whose finite cells mirror a Complex slot by slot. Deterministic:
/// `removed` is ascending by slot, and its slots are freed in that order; `added` is sorted by the ascending
/// vertex ids of its tetrahedra, which take the slot freed last, or a new one at the end of the array when
/// none is free. Hints cost or save time only; points on facets, edges and cospherical points are settled by
/// CGAL's symbolic perturbation, which depends on points only.
class Delaunay {
 public:
  Delaunay();
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  /// Starts anew from the eight box corners (any distinct points): the delta that builds T from nothing.
  /// Without tetrahedra when the points are coplanar.
  Delta start(std::span<const Vertex> corners);

  /// What inserting `vertex` would do, applied to the triangulation. `hint` is a tetrahedron at or near the
  /// point. nullopt when the point is a vertex already, lies outside the hull or is not finite: nothing is
  /// changed then. The new vertex's id follows the last one.
  std::optional<Delta> insert(const Vertex& vertex, TetId hint);

  /// Whether p lies strictly inside the circumscribed ball of the tetrahedron (exact).
  bool strictly_inside_circumsphere(TetId t, Vec3 p) const;
  /// Circumcentre in floating point; for slivers it may be far away or non-finite.
  Vec3 circumcenter(TetId t) const;
  /// The tetrahedron that holds p, that of the smallest slot where several do, invalid when outside; exact,
  /// walks from the hint.
  TetId locate(Vec3 p, TetId hint) const;
  /// The vertex nearest to p, the one of smallest id where several are (exact), searched from the hint.
  VertexId nearest_vertex(Vec3 p, TetId hint) const;
  /// Across from each vertex of a living tetrahedron, in the order of Tet; invalid at the hull.
  std::array<TetId, 4> neighbours(TetId t) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
