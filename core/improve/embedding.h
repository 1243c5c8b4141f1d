// Z as facets of T while it is improved: which vertex of the surface is which vertex of T, what T allows, and
// commits to it.
#pragma once

#include "collapse/live_complex.h"
#include "collapse/tet_patch.h"
#include "journal/refusal.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Reading is thread-safe, commits are for one thread.
class Embedding {
 public:
  static constexpr std::uint32_t not_on_surface = 0xffffffffu;

  /// `vertices`: by vertex of the surface, its vertex of T; ascending.
  Embedding(LiveComplex& live, std::vector<VertexId> vertices);

  const Complex& complex() const { return live_.complex(); }
  VertexId vertex(std::uint32_t surface_vertex) const { return vertices_[surface_vertex]; }
  /// not_on_surface for other vertices of T.
  std::uint32_t surface_vertex(VertexId v) const { return surface_[v.index()]; }
  /// Vertices of the surface around which T has changed later than at `time` of the state's clock, ascending.
  std::vector<std::uint32_t> changed_since(std::uint32_t time) const;
  std::uint32_t clock() const { return live_.clock(); }

  /// All tetrahedra around these vertices of the surface.
  TetPatch around(std::span<const std::uint32_t> surface_vertices) const;
  /// The tetrahedron between four vertices of the surface, alone; nothing where they are not those of one, or
  /// a facet of it is dropped.
  std::optional<TetPatch> tet_between(const std::array<std::uint32_t, 4>& surface_vertices) const;
  /// Whether T allows to merge the ends of an edge of Z (link conditions, kernel), perhaps after flips, and
  /// where: `kernel` is filled when it does.
  Refusal check_edge(std::uint32_t a, std::uint32_t b, Kernel& kernel) const;

  /// Takes the patch over; it must be up to date.
  Delta commit(const TetPatch& patch);

 private:
  LiveComplex& live_;
  std::vector<VertexId> vertices_;
  std::vector<std::uint32_t> surface_; ///< by vertex of T
};

} // namespace isoscope
