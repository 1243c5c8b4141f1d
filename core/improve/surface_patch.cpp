// Copies neighbourhoods out of a surface.
#include "improve/surface_patch.h"

#include "base/sort_unique.h"

#include <algorithm>

namespace isoscope {
namespace {

/// The border edges of the patch's facets.
void take_border(const FacetComplex& surface, SurfacePatch& patch) {
  FacetComplex& own = patch.complex;
  own.border.resize(own.points.size());
  patch.start_border.resize(own.points.size());
  for (std::uint32_t v = 0; v < own.points.size(); ++v) {
    const BorderEdge& edge = surface.border[patch.vertices[v]];
    if (edge.here()) {
      const std::uint32_t next = patch.local_vertex(edge.next);
      const bool has_vertex = next < own.points.size() && patch.vertices[next] == edge.next;
      if (has_vertex && own.facet_left_of(v, next) != Facet::none) {
        own.border[v] = edge;
        own.border[v].next = next;
      } else {
        own.border[v].next = BorderEdge::elsewhere;
      }
    }
    patch.start_border[v] = own.border[v].next;
  }
}

SurfacePatch take(const FacetComplex& surface, std::vector<std::uint32_t> slots,
                  std::span<const std::uint32_t> free_vertices) {
  SurfacePatch patch;
  patch.slots = std::move(slots);
  patch.vertices.reserve(patch.slots.size());
  for (const std::uint32_t f : patch.slots)
    for (const std::uint32_t v : surface.facets[f].v) patch.vertices.push_back(v);
  sort_unique(patch.vertices);
  patch.free.assign(patch.vertices.size(), 0);
  for (const std::uint32_t v : free_vertices) patch.free[patch.local_vertex(v)] = 1;
  patch.complex.points.reserve(patch.vertices.size());
  for (const std::uint32_t v : patch.vertices) patch.complex.points.push_back(surface.points[v]);
  patch.complex.facets.reserve(patch.slots.size());
  patch.start_facets.reserve(patch.slots.size());
  for (const std::uint32_t f : patch.slots) {
    Facet facet = surface.facets[f];
    for (std::uint32_t& v : facet.v) v = patch.local_vertex(v);
    patch.start_facets.push_back(facet.v);
    patch.start_misoriented += facet.misoriented;
    patch.start_folded += facet.folded ? 1u : 0u;
    patch.complex.facets.push_back(std::move(facet));
  }
  patch.complex.build_stars();
  if (!surface.border.empty()) take_border(surface, patch);
  if (!surface.strata.empty()) patch.complex.strata = take_strata(surface, patch.vertices);
  patch.start_points = patch.complex.points;
  patch.outside.reserve(patch.vertices.size());
  for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    patch.outside.push_back(
        static_cast<std::uint32_t>(surface.stars[patch.vertices[i]].size() - patch.complex.stars[i].size()));
  return patch;
}

} // namespace

std::uint32_t SurfacePatch::local_vertex(std::uint32_t surface_vertex) const {
  return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), surface_vertex) -
                                    vertices.begin());
}

bool SurfacePatch::has_slot(std::uint32_t slot) const {
  return std::binary_search(slots.begin(), slots.end(), slot);
}

bool SurfacePatch::changed(std::size_t f) const {
  if (complex.facets[f].v != start_facets[f]) return true;
  if (!complex.facets[f].alive()) return false;
  return std::any_of(start_facets[f].begin(), start_facets[f].end(),
                     [&](std::uint32_t v) { return complex.points[v] != start_points[v]; });
}

bool SurfacePatch::border_changed(std::uint32_t v) const {
  const std::uint32_t before = start_border[v], now = complex.border[v].next;
  if (before != now) return true;
  return complex.border[v].here() &&
         (complex.points[v] != start_points[v] || complex.points[now] != start_points[now]);
}

double SurfacePatch::largest_distance(double delta) const {
  double largest = 0;
  for (std::size_t f = 0; f < complex.facets.size(); ++f)
    if (complex.facets[f].alive() && changed(f)) largest = std::max(largest, complex.facets[f].largest);
  // Tests of condition 3 are among the samples, with distances beyond δ where they fail.
  return std::min(largest, delta);
}

Triangle3 SurfacePatch::start_triangle(std::size_t f) const {
  const auto& v = start_facets[f];
  return {start_points[v[0]], start_points[v[1]], start_points[v[2]]};
}

std::array<std::uint32_t, 3> SurfacePatch::surface_corners(const std::array<std::uint32_t, 3>& v) const {
  return {vertices[v[0]], vertices[v[1]], vertices[v[2]]};
}

std::vector<std::uint32_t> vertices_around(const FacetComplex& surface, std::vector<std::uint32_t> from,
                                           int rings) {
  sort_unique(from);
  for (int r = 0; r < rings; ++r) {
    const std::size_t count = from.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const std::uint32_t f : surface.stars[from[i]])
        for (const std::uint32_t v : surface.facets[f].v) from.push_back(v);
    sort_unique(from);
  }
  return from;
}

SurfacePatch take_patch(const FacetComplex& surface, std::span<const std::uint32_t> free_vertices) {
  std::vector<std::uint32_t> slots;
  for (const std::uint32_t v : free_vertices)
    slots.insert(slots.end(), surface.stars[v].begin(), surface.stars[v].end());
  sort_unique(slots);
  return take(surface, std::move(slots), free_vertices);
}

SurfacePatch take_facets(const FacetComplex& surface, std::span<const std::uint32_t> slots) {
  return take(surface, {slots.begin(), slots.end()}, {});
}

} // namespace isoscope
