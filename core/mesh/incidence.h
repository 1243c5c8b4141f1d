// Which tetrahedra meet at each vertex of T: kept beside a state, brought along by its deltas.
#pragma once

#include "mesh/complex.h"
#include "mesh/edge_star.h"

#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Tetrahedra by vertex. Any order-dependent use sorts: the lists' order depends on history.
class Incidence {
 public:
  explicit Incidence(const Complex& complex);
  std::span<const TetId> tets_of(VertexId v) const { return tets_[v.index()]; }
  bool adjacent(const Complex& complex, VertexId a, VertexId b) const;
  /// After `delta` was applied to the complex.
  void apply(const Delta& delta);

 private:
  std::vector<std::vector<TetId>> tets_;
  void add(const TetRecord& tet);
  void remove(const TetRecord& tet);
};

/// How far the planes of the error reach from the edge (§2.4 says the 2-ring; the 1-ring gave 2 to 15 % fewer
/// vertices, core/README.md, N5).
enum class CostRing : std::uint8_t { one, two };

/// Copies the star of an edge of T; `a` stays. Samples are left out.
EdgeStar gather_edge_star(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                          CostRing ring);

/// What collapsing the edge ab of T changes: a stays and goes to `target`, the tetrahedra at both vanish.
Delta collapse_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b, Vec3 target);

/// What splitting the edge ab of an embedded T at a point of it changes: a vertex of Z comes, each
/// tetrahedron at both falls into two, which keep its side and its dropped facets. Nothing where one would
/// turn over, by exact orientations.
std::optional<Delta> split_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                                 Vec3 point);

/// What turning the edge ab of an embedded Z within its two facets changes, where four tetrahedra are around
/// it, none of whose facets is dropped: others around the edge between what is opposite to it in Z take their
/// place. Nothing where there are more, where that edge is one of T already, or where one would turn over, by
/// exact orientations.
std::optional<Delta> flip_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b);

} // namespace isoscope
