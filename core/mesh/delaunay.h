// Delaunay insertion into T: CGAL finds the conflict zone, we get a delta with stable slots.
#pragma once

#include "mesh/complex.h"

#include <memory>
#include <span>

namespace isoscope {

/// Incremental 3D Delaunay triangulation whose finite cells mirror a Complex slot by slot. Deterministic: slots are handed
/// out in the order of the sorted vertex tuples, freed slots are reused last-in first-out.
class Delaunay {
public:
  Delaunay();
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  /// Starts from the eight box corners (any affinely independent points): the delta that builds T from nothing.
  Delta start(std::span<const Vertex> corners);

  /// What inserting `vertex` would do, applied to the triangulation. `hint` is a tetrahedron at or near the point.
  /// nullopt when the point is a vertex already, or lies outside the box: nothing is changed then.
  std::optional<Delta> insert(const Vertex& vertex, TetId hint);

  /// Whether p lies strictly inside the circumscribed ball of the tetrahedron (exact).
  bool strictly_inside_circumsphere(TetId t, Vec3 p) const;
  /// Circumcentre in floating point; for slivers it may be far away or non-finite.
  Vec3 circumcenter(TetId t) const;
  /// The finite tetrahedron that holds p, invalid when outside; exact, walks from the hint.
  TetId locate(Vec3 p, TetId hint) const;
  /// The vertex nearest to p, searched from the hint.
  VertexId nearest_vertex(Vec3 p, TetId hint) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
