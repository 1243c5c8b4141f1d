// A part of T as a value: the tetrahedra around vertices of Z, to be changed while they stay positively
// oriented and then committed or thrown away.
#pragma once

#include "criteria/kernel.h"
#include "mesh/complex.h"
#include "mesh/edge_star.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Copies of tetrahedra with local numbers, ascending like those of T. Vertices may be moved, merged, and
/// have tetrahedra at them replaced only where every tetrahedron that they are a corner of is here.
class TetPatch {
 public:
  /// A tetrahedron, positively oriented.
  struct LocalTet {
    std::array<std::uint32_t, 4> v{};
    std::int8_t side = 0;
    bool alive = true;
    bool has(std::uint32_t vertex) const;
    friend bool operator==(const LocalTet&, const LocalTet&) = default;
  };

  /// `tets` ascending.
  TetPatch(const Complex& complex, std::span<const TetId> tets);

  std::span<const VertexId> vertices() const { return vertices_; } ///< by local number
  std::uint32_t local(VertexId v) const;                           ///< of a vertex that is here
  Vec3 point(std::uint32_t v) const { return points_[v]; }
  const LocalTet& tet(std::uint32_t t) const { return tets_[t]; }
  std::span<const std::uint32_t> tets_at(std::uint32_t v) const { return at_[v]; } ///< ascending, alive

  /// Where v may lie: the facets opposite to it, and their half-spaces. Neither ball nor witness is looked
  /// for.
  Kernel kernel(VertexId v) const;
  /// The star of an edge of Z, like gather_edge_star's, without the facets of its error.
  EdgeStar star(VertexId a, VertexId b) const;
  /// The tetrahedron with these corners; nothing where a facet of it is dropped: it cannot change sides.
  std::optional<std::uint32_t> tet_between(const std::array<VertexId, 4>& corners) const;

  void move(VertexId v, Vec3 to) { points_[local(v)] = to; }
  /// Merges b into a at a point of the kernel of their edge; the link condition must hold.
  void collapse(VertexId a, VertexId b, Vec3 to);
  void change_side(std::uint32_t tet) { tets_[tet].side = static_cast<std::int8_t>(-tets_[tet].side); }
  /// Fills the space of some tetrahedra with others.
  void replace(std::span<const std::uint32_t> removed, std::span<const LocalTet> added);

  /// Whether the complex still has these tetrahedra where they were taken from.
  bool up_to_date(const Complex& complex) const;
  /// What turns the complex into this; `slots` is the length of its array of tetrahedra. Neighbours of a
  /// tetrahedron that changes sides are in it too: a facet of Z is told from both its tetrahedra.
  Delta delta(std::size_t slots) const;

 private:
  bool moved(const LocalTet& tet) const;
  std::vector<std::uint8_t> changed() const;
  TetRecord record(TetId slot, const LocalTet& tet, std::uint8_t dropped) const;
  void add(const LocalTet& tet);
  /// Its dropped facets, as in Tet.
  std::uint8_t dropped_of(const LocalTet& tet) const;

  std::vector<VertexId> vertices_;
  std::vector<Vertex> start_; ///< by local vertex
  std::vector<Vec3> points_;
  std::vector<TetId> slots_; ///< of the first tetrahedra; those that were added have none yet
  std::vector<LocalTet> tets_, start_tets_;
  std::vector<std::uint8_t> start_dropped_;           ///< by tetrahedron of the complex
  std::vector<std::array<std::uint32_t, 3>> dropped_; ///< the facets, their vertices and they ascending
  std::vector<std::vector<std::uint32_t>> at_;        ///< by local vertex
  std::vector<VertexId> killed_;
};

/// What turned one state of T into another that differs in positions and sides only: for sweeps of many small
/// changes.
Delta difference(const Complex& before, const Complex& after);

} // namespace isoscope
