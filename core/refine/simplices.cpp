// Gathered from the tetrahedra that are alive.
#include "refine/simplices.h"

namespace isoscope {

std::array<Simplex<2>, 6> edges_of(const Tet& tet, TetId t) {
  std::array<Simplex<2>, 6> edges;
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const auto [a, b] = std::minmax(tet.v[i], tet.v[j]);
      edges[k++] = {{a, b}, t};
    }
  }
  return edges;
}

void append_edges(const Complex& complex, TetId t, std::vector<Simplex<2>>& edges) {
  for (const Simplex<2>& edge : edges_of(complex.tet(t), t)) edges.push_back(edge);
}

void append_facets_of_one_label(const Complex& complex, TetId t, std::vector<Simplex<3>>& facets) {
  const Tet& tet = complex.tet(t);
  for (std::size_t i = 0; i < 4; ++i) {
    Simplex<3> facet{{}, t};
    int positives = 0;
    for (std::size_t j = 0, k = 0; j < 4; ++j) {
      if (j == i) continue;
      facet.v[k++] = tet.v[j];
      positives += complex.value(tet.v[j]) > 0 ? 1 : 0;
    }
    if (positives != 0 && positives != 3) continue;
    std::sort(facet.v.begin(), facet.v.end());
    facets.push_back(facet);
  }
}

std::vector<Simplex<2>> all_edges(const Complex& complex) {
  std::vector<Simplex<2>> edges;
  for (std::uint32_t t = 0; t < complex.tets.size(); ++t)
    if (complex.tets[t].alive()) append_edges(complex, TetId(t), edges);
  sort_unique(edges);
  return edges;
}

std::vector<Simplex<3>> facets_of_one_label(const Complex& complex) {
  std::vector<Simplex<3>> facets;
  for (std::uint32_t t = 0; t < complex.tets.size(); ++t)
    if (complex.tets[t].alive()) append_facets_of_one_label(complex, TetId(t), facets);
  sort_unique(facets);
  return facets;
}

} // namespace isoscope
