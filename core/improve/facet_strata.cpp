// Strata from stars, and how they change with a collapse.
#include "improve/facet_strata.h"

#include "base/sort_unique.h"
#include "improve/surface_patch.h"
#include "improve/swept_witness.h"

#include <algorithm>
#include <array>
#include <utility>

namespace isoscope {
namespace {

std::vector<LinkArc> link_of(const FacetComplex& complex, std::uint32_t v) {
  std::vector<LinkArc> link;
  link.reserve(complex.stars[v].size());
  for (const std::uint32_t f : complex.stars[v]) {
    const Facet& facet = complex.facets[f];
    const std::size_t k = facet.corner(v);
    link.push_back(
        {facet.v[(k + 1) % 3], facet.v[(k + 2) % 3], {facet.labels.back, facet.labels.front, false}});
  }
  return link;
}

std::ptrdiff_t facets_at(std::span<const LinkArc> link, std::uint32_t end) {
  return std::count_if(link.begin(), link.end(),
                       [end](const LinkArc& arc) { return arc.from == end || arc.to == end; });
}

/// Whether each sheet at the vertex lies between curves.
bool all_between_curves(std::span<const LinkArc> link, std::vector<std::uint32_t> reached) {
  std::vector<LinkArc> left(link.begin(), link.end());
  for (std::size_t i = 0; i < reached.size(); ++i)
    std::erase_if(left, [&, from = reached[i]](const LinkArc& arc) {
      if (arc.from != from && arc.to != from) return false;
      reached.push_back(arc.from == from ? arc.to : arc.from);
      return true;
    });
  return left.empty();
}

VertexStratum stratum_at(const FacetComplex& complex, std::uint32_t v) {
  const std::vector<LinkArc> link = link_of(complex, v);
  VertexStratum at;
  at.stratum = stratum_of(link);
  if (at.stratum == Stratum::sheet) return at;
  at.curves = curves_from(link);
  at.rigid = !all_between_curves(link, at.curves) ||
             std::any_of(at.curves.begin(), at.curves.end(),
                         [&](std::uint32_t end) { return facets_at(link, end) < 3; });
  if (at.rigid) at.stratum = Stratum::point;
  return at;
}

void insert_sorted(std::vector<std::uint32_t>& list, std::uint32_t value) {
  const auto at = std::lower_bound(list.begin(), list.end(), value);
  if (at == list.end() || *at != value) list.insert(at, value);
}

/// The labels of the facets at a vertex, ascending.
std::vector<std::int8_t> labels_at(const FacetComplex& complex, std::uint32_t v) {
  std::vector<std::int8_t> labels;
  for (const std::uint32_t f : complex.stars[v]) {
    labels.push_back(complex.facets[f].labels.front);
    labels.push_back(complex.facets[f].labels.back);
  }
  sort_unique(labels);
  return labels;
}

/// The neighbours of a vertex on the boundary of a region, ascending.
std::vector<std::uint32_t> neighbors_around(const FacetComplex& complex, std::uint32_t v, std::int8_t label) {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t f : complex.stars[v])
    if (complex.facets[f].bounds(label))
      for (const std::uint32_t w : complex.facets[f].v)
        if (w != v) found.push_back(w);
  sort_unique(found);
  return found;
}

/// Whether the boundary of a region, which has both vertices, remains the surface that it is.
bool keeps_region(const FacetComplex& complex, std::uint32_t a, std::uint32_t b, std::int8_t label) {
  const auto along = std::count_if(complex.stars[a].begin(), complex.stars[a].end(), [&](std::uint32_t f) {
    return complex.facets[f].has(b) && complex.facets[f].bounds(label);
  });
  if (along != 2) return false;
  const std::vector<std::uint32_t> of_a = neighbors_around(complex, a, label),
                                   of_b = neighbors_around(complex, b, label);
  const auto common = std::count_if(of_a.begin(), of_a.end(), [&](std::uint32_t v) {
    return std::binary_search(of_b.begin(), of_b.end(), v);
  });
  return common == 2;
}

/// Whether no two facets would become one.
bool keeps_facets(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t f : complex.stars[a]) {
    const Facet& facet = complex.facets[f];
    if (facet.has(b)) continue;
    const std::size_t k = facet.corner(a);
    const std::uint32_t x = facet.v[(k + 1) % 3], y = facet.v[(k + 2) % 3];
    for (const std::uint32_t g : complex.stars[b])
      if (complex.facets[g].has(x) && complex.facets[g].has(y)) return false;
  }
  return true;
}

} // namespace

bool VertexStratum::leads_to(std::uint32_t vertex) const {
  return std::binary_search(curves.begin(), curves.end(), vertex);
}

std::vector<VertexStratum> find_strata(const FacetComplex& complex) {
  std::vector<VertexStratum> strata(complex.points.size());
  for (std::uint32_t v = 0; v < strata.size(); ++v)
    if (complex.alive_vertex(v)) strata[v] = stratum_at(complex, v);
  return strata;
}

std::vector<VertexStratum> take_strata(const FacetComplex& surface, std::span<const std::uint32_t> vertices) {
  std::vector<VertexStratum> strata;
  strata.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    const VertexStratum& whole = surface.strata[v];
    VertexStratum& own = strata.emplace_back(VertexStratum{whole.stratum, whole.rigid, {}});
    for (const std::uint32_t end : whole.curves) {
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), end);
      if (at != vertices.end() && *at == end)
        own.curves.push_back(static_cast<std::uint32_t>(at - vertices.begin()));
    }
  }
  return strata;
}

void renew_strata(FacetComplex& complex, std::span<const std::uint32_t> vertices) {
  for (const std::uint32_t v : vertices)
    complex.strata[v] = complex.alive_vertex(v) ? stratum_at(complex, v) : VertexStratum{};
}

bool strata_link_condition(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  if (complex.is_rigid(a) && complex.is_rigid(b)) return false;
  const std::vector<std::int8_t> of_a = labels_at(complex, a), of_b = labels_at(complex, b);
  for (const std::int8_t label : of_a)
    if (std::binary_search(of_b.begin(), of_b.end(), label) && !keeps_region(complex, a, b, label))
      return false;
  return keeps_facets(complex, a, b);
}

void merge_strata(FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  renew_strata(complex, std::array{a, b});
  for (const std::uint32_t end : complex.neighbors(a)) {
    std::vector<std::uint32_t>& curves = complex.strata[end].curves;
    std::erase(curves, b);
    if (complex.strata[a].leads_to(end))
      insert_sorted(curves, a);
    else
      std::erase(curves, a);
  }
}

std::optional<std::uint32_t> pinned_end(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  const VertexStratum &at_a = complex.strata[a], &at_b = complex.strata[b];
  if (at_a.rigid || at_b.rigid) return at_a.rigid ? a : b;
  if (at_a.on_curve() == at_b.on_curve()) return std::nullopt;
  return at_a.on_curve() ? a : b;
}

std::optional<Vec3> swept_witness_between_rooms(std::span<const Vec3> witnesses, const SurfacePatch& patch) {
  std::vector<std::int8_t> labels;
  for (const Facet& f : patch.complex.facets)
    for (const std::int8_t label : {f.labels.front, f.labels.back}) labels.push_back(label);
  sort_unique(labels);
  for (const std::int8_t label : labels) {
    std::vector<Triangle3> before, after;
    for (std::size_t f = 0; f < patch.complex.facets.size(); ++f) {
      const Facet& facet = patch.complex.facets[f];
      if (!patch.changed(f) || !facet.bounds(label)) continue;
      const auto turned = [&](Triangle3 t) {
        if (facet.labels.front == label) std::swap(t[1], t[2]);
        return t;
      };
      before.push_back(turned(patch.start_triangle(f)));
      if (facet.alive()) after.push_back(turned(patch.complex.triangle(facet)));
    }
    if (auto swept = swept_witness(witnesses, before, after)) return swept;
  }
  return std::nullopt;
}

} // namespace isoscope
