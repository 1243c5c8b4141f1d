// Edges and facets of T, each once.
#pragma once

#include "mesh/complex.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace isoscope {

/// An edge or facet, its vertices ascending, with the first tetrahedron that has it.
template <std::size_t N> struct Simplex {
  std::array<VertexId, N> v;
  TetId tet;
};

/// In the order of their vertices.
template <std::size_t N> void sort_unique(std::vector<Simplex<N>>& simplices) {
  std::sort(simplices.begin(), simplices.end(),
            [](const auto& a, const auto& b) { return std::tie(a.v, a.tet) < std::tie(b.v, b.tet); });
  const auto same = [](const auto& a, const auto& b) { return a.v == b.v; };
  simplices.erase(std::unique(simplices.begin(), simplices.end(), same), simplices.end());
}

/// Both ends of an edge in any order as one number.
inline std::uint64_t packed(VertexId a, VertexId b) {
  const auto [low, high] = std::minmax(a.value, b.value);
  return (std::uint64_t{low} << 32) | high;
}

std::array<Simplex<2>, 6> edges_of(const Tet& tet, TetId t);
/// Adds those of one tetrahedron.
void append_edges(const Complex& complex, TetId t, std::vector<Simplex<2>>& edges);
void append_facets_of_one_label(const Complex& complex, TetId t, std::vector<Simplex<3>>& facets);
std::vector<Simplex<2>> all_edges(const Complex& complex);
std::vector<Simplex<3>> facets_of_one_label(const Complex& complex);

} // namespace isoscope
