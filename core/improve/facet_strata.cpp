// Strata from stars, and how they change with a collapse.
#include "improve/facet_strata.h"

#include "base/sort_unique.h"
#include "improve/surface_patch.h"
#include "improve/swept_witness.h"

#include <algorithm>
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

void exchange(std::vector<std::uint32_t>& list, std::uint32_t out, std::uint32_t in) {
  std::erase(list, out);
  insert_sorted(list, in);
}

bool intersect(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t v) { return std::binary_search(b.begin(), b.end(), v); });
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
    VertexStratum& own = strata.emplace_back(surface.strata[v]);
    for (std::uint32_t& end : own.curves) {
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), end);
      const bool here = at != vertices.end() && *at == end;
      end = here ? static_cast<std::uint32_t>(at - vertices.begin()) : end | VertexStratum::elsewhere;
    }
    std::sort(own.curves.begin(), own.curves.end());
  }
  return strata;
}

void commit_strata(const SurfacePatch& patch, FacetComplex& surface) {
  const auto of_surface = [&](std::uint32_t end) {
    return end >= VertexStratum::elsewhere ? end - VertexStratum::elsewhere : patch.vertices[end];
  };
  for (std::uint32_t v = 0; v < patch.vertices.size(); ++v) {
    const VertexStratum &before = patch.start_strata[v], &now = patch.complex.strata[v];
    if (before == now) continue;
    // Others may have changed what is no part of this patch.
    VertexStratum& own = surface.strata[patch.vertices[v]];
    own.stratum = now.stratum;
    own.rigid = now.rigid;
    for (const std::uint32_t end : before.curves)
      if (!now.leads_to(end)) std::erase(own.curves, of_surface(end));
    for (const std::uint32_t end : now.curves)
      if (!before.leads_to(end)) insert_sorted(own.curves, of_surface(end));
  }
}

bool strata_link_condition(const FacetComplex& complex, std::uint32_t a, std::uint32_t b) {
  const VertexStratum &at_a = complex.strata[a], &at_b = complex.strata[b];
  const bool along_curve = at_a.leads_to(b);
  // The dummy vertices: on two curves, or between two points.
  if (at_a.on_curve() && at_b.on_curve() && !along_curve) return false;
  if (at_a.stratum == Stratum::point && at_b.stratum == Stratum::point) return false;
  if (intersect(at_a.curves, at_b.curves)) return false;
  const std::vector<std::uint32_t> of_a = complex.neighbors(a), of_b = complex.neighbors(b);
  std::size_t common = 0, opposite = 0;
  for (const std::uint32_t v : of_a) common += std::binary_search(of_b.begin(), of_b.end(), v) ? 1u : 0u;
  for (const std::uint32_t f : complex.stars[a]) {
    const Facet& facet = complex.facets[f];
    if (facet.has(b)) {
      ++opposite;
      continue;
    }
    const std::size_t k = facet.corner(a);
    const std::uint32_t x = facet.v[(k + 1) % 3], y = facet.v[(k + 2) % 3];
    for (const std::uint32_t g : complex.stars[b])
      if (complex.facets[g].has(x) && complex.facets[g].has(y)) return false;
  }
  return common == opposite;
}

void merge_strata(std::vector<VertexStratum>& strata, std::uint32_t a, std::uint32_t b) {
  VertexStratum gone = std::exchange(strata[b], {});
  VertexStratum& stays = strata[a];
  std::erase(stays.curves, b);
  for (const std::uint32_t end : gone.curves) {
    if (end == a) continue;
    exchange(strata[end].curves, b, a);
    insert_sorted(stays.curves, end);
  }
  stays.stratum = std::min(stays.stratum, gone.stratum);
  stays.rigid = stays.rigid || gone.rigid;
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
      if (!patch.changed(f) || (facet.labels.front != label && facet.labels.back != label)) continue;
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
