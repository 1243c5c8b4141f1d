// A part of T as a value: the tetrahedra around vertices of Z, to be changed while they stay positively oriented
// and then committed or thrown away.
#pragma once

#include "criteria/kernel.h"
#include "mesh/complex.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Copies of tetrahedra with local numbers. Vertices may be moved, merged or have a tetrahedron between them
/// change sides only where every tetrahedron they are a corner of is here.
class TetPatch {
 public:
  /// `tets` ascending.
  TetPatch(const Complex& complex, std::span<const TetId> tets);

  std::span<const VertexId> vertices() const { return vertices_; } ///< ascending
  /// Where v may lie: the facets opposite to it, and their half-spaces. Neither ball nor witness is looked for.
  Kernel kernel(VertexId v) const;
  void move(VertexId v, Vec3 to);
  /// Merges b into a at a point of the kernel of their edge; the link condition must hold.
  void collapse(VertexId a, VertexId b, Vec3 to);
  /// The tetrahedron abcd, which holds the flip of an edge ab of Z: when it changes sides, cd takes its place.
  std::optional<std::uint32_t> tet_between(const std::array<VertexId, 4>& corners) const;
  void change_side(std::uint32_t tet) { tets_[tet].side = static_cast<std::int8_t>(-tets_[tet].side); }

  /// Whether the complex still has these tetrahedra where they were taken from.
  bool up_to_date(const Complex& complex) const;
  /// What turns the complex into this; `slots` is the length of its array of tetrahedra.
  Delta delta(std::size_t slots) const;

 private:
  struct LocalTet {
    std::array<std::uint32_t, 4> v{};
    std::int8_t side = 0;
    bool alive = true;
    friend bool operator==(const LocalTet&, const LocalTet&) = default;
  };
  std::uint32_t local(VertexId v) const;
  bool moved(const LocalTet& tet) const;
  TetRecord record(std::size_t i, const LocalTet& tet) const;

  std::vector<VertexId> vertices_;
  std::vector<Vec3> points_, start_points_;
  std::vector<TetId> slots_;
  std::vector<LocalTet> tets_, start_tets_;
  std::vector<std::vector<std::uint32_t>> at_; ///< by local vertex: tetrahedra
  std::vector<VertexId> killed_;
};

/// What turned one state of T into another that has the same vertices and slots: for sweeps of many small
/// changes.
Delta difference(const Complex& before, const Complex& after);

} // namespace isoscope
