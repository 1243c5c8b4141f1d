// A part of Z as a value: the neighbourhood of an edge, to be changed and then committed or thrown away.
#pragma once

#include "collapse/tet_patch.h"
#include "improve/facet_complex.h"

#include <optional>
#include <span>

namespace isoscope {

/// All facets around some free vertices, with local ids in the order of the surface's.
struct SurfacePatch {
  FacetComplex complex;
  std::vector<std::uint32_t> vertices; ///< local vertex -> vertex of the surface, ascending
  std::vector<std::uint32_t> slots;    ///< local facet -> slot of the surface, ascending
  std::vector<std::uint8_t> free;      ///< by local vertex: its whole star is here and it may move
  std::vector<std::uint32_t> outside;  ///< by local vertex: facets of it that are not here
  std::vector<Vec3> start_points;      ///< as they were taken from the surface
  std::vector<std::array<std::uint32_t, 3>> start_facets;
  std::vector<std::uint32_t> start_border; ///< by local vertex: where its border edge led; empty if none did
  std::uint32_t start_misoriented = 0;     ///< failed tests of all facets
  std::uint32_t start_folded = 0;          ///< folded facets

  /// What it holds of T, where Z is improved inside it.
  struct InT {
    TetPatch tets;
    std::vector<VertexId> vertices;       ///< by local vertex
    std::vector<std::uint32_t> looked_at; ///< vertices of the surface that are corners of the tetrahedra
  };
  std::optional<InT> in_t;

  std::uint32_t local_vertex(std::uint32_t surface_vertex) const;
  bool has_slot(std::uint32_t slot) const;
  std::size_t valence(std::uint32_t local) const { return complex.stars[local].size() + outside[local]; }
  bool may_lose_facet(std::uint32_t local) const { return valence(local) > complex.fewest_facets(local); }
  /// Whether the facet is not what was taken from the surface: other corners, or the same at other places.
  bool changed(std::size_t local_facet) const;
  Triangle3 start_triangle(std::size_t local_facet) const;
  /// The same for the border edge that begins, or began, at a vertex.
  bool border_changed(std::uint32_t local) const;
  /// The largest sampled d of the changed facets; at most `delta`, which is proven of them.
  double largest_distance(double delta) const;
  std::array<std::uint32_t, 3> surface_corners(const std::array<std::uint32_t, 3>& local) const;
};

/// Vertices at most `rings` edges from the given ones, ascending, these included.
std::vector<std::uint32_t> vertices_around(const FacetComplex& surface, std::vector<std::uint32_t> from,
                                           int rings);
/// Takes all facets around the free vertices (ascending).
SurfacePatch take_patch(const FacetComplex& surface, std::span<const std::uint32_t> free_vertices);
/// Takes these facets (ascending) with all vertices fixed.
SurfacePatch take_facets(const FacetComplex& surface, std::span<const std::uint32_t> slots);

} // namespace isoscope
