// Finds what is joined among vertices of one label, and which components of Z lie around it.
#include "refine/pockets.h"

#include "base/disjoint_sets.h"
#include "mesh/zero_set.h"

#include <algorithm>
#include <cstdint>

namespace isoscope {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

DisjointSets joined_by_label(const Complex& complex) {
  DisjointSets sets(complex.vertices.size());
  for (const Tet& tet : complex.tets) {
    if (!tet.alive()) continue;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (complex.label(tet.v[i]) == complex.label(tet.v[j])) sets.unite(tet.v[i].value, tet.v[j].value);
  }
  return sets;
}

bool is_free(VertexKind kind) {
  return kind == VertexKind::containment || kind == VertexKind::topology;
}

} // namespace

std::vector<std::vector<VertexId>> find_pockets(const Complex& complex) {
  const ZeroSet z = extract_zero_set(complex);
  DisjointSets sets = joined_by_label(complex);
  // By set: the component of Z around it, or that there are several.
  constexpr std::uint32_t several = none - 1;
  std::vector<std::uint32_t> around(complex.vertices.size(), none);
  for (const ZeroSet::Polygon& p : z.polygons)
    for (std::size_t k = 0; k < p.count; ++k)
      for (const VertexId v : {z.vertices[p.v[k]].negative, z.vertices[p.v[k]].positive}) {
        std::uint32_t& component = around[sets.find(v.value)];
        component = component == none || component == p.component ? p.component : several;
      }
  std::vector<bool> bound(complex.vertices.size(), false);
  for (std::uint32_t v = 0; v < complex.vertices.size(); ++v)
    if (!is_free(complex.vertices[v].kind)) bound[sets.find(v)] = true;
  std::vector<std::vector<VertexId>> inside(z.components.size());
  for (std::uint32_t v = 0; v < complex.vertices.size(); ++v) {
    const std::uint32_t set = sets.find(v), component = around[set];
    if (bound[set] || component >= several) continue;
    if (z.components[component].euler_characteristic() == 2) inside[component].push_back(VertexId(v));
  }
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < inside.size(); ++c)
    if (!inside[c].empty()) order.push_back(c);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return z.components[a].vertices < z.components[b].vertices;
  });
  std::vector<std::vector<VertexId>> pockets;
  for (const std::size_t c : order) pockets.push_back(std::move(inside[c]));
  return pockets;
}

} // namespace isoscope
