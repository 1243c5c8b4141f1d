// Neighbourhoods of T by vertices of Z.
#include "improve/embedding.h"

#include "base/sort_unique.h"
#include "collapse/tet_flips.h"

#include <algorithm>
#include <utility>

namespace isoscope {

Embedding::Embedding(LiveComplex& live, std::vector<VertexId> vertices)
    : live_(live), vertices_(std::move(vertices)), surface_(live.complex().vertices.size(), not_on_surface) {
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) surface_[vertices_[v].index()] = v;
}

std::vector<std::uint32_t> Embedding::changed_since(std::uint32_t time) const {
  std::vector<std::uint32_t> changed;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (live_.alive(vertices_[v]) && live_.changed(vertices_[v]) > time) changed.push_back(v);
  return changed;
}

TetPatch Embedding::around(std::span<const std::uint32_t> surface_vertices) const {
  std::vector<TetId> tets;
  for (const std::uint32_t v : surface_vertices) {
    const auto at = live_.incidence().tets_of(vertices_[v]);
    tets.insert(tets.end(), at.begin(), at.end());
  }
  sort_unique(tets);
  return {complex(), tets};
}

std::optional<TetPatch> Embedding::tet_between(const std::array<std::uint32_t, 4>& corners) const {
  std::array<VertexId, 4> wanted;
  for (std::size_t k = 0; k < 4; ++k) wanted[k] = vertices_[corners[k]];
  for (const TetId t : live_.incidence().tets_of(wanted[0]))
    if (complex().tet(t).dropped == 0 &&
        std::is_permutation(wanted.begin(), wanted.end(), complex().tet(t).v.begin()))
      return TetPatch(complex(), std::array{t});
  return std::nullopt;
}

Refusal Embedding::check_edge(std::uint32_t a, std::uint32_t b, Kernel& kernel) const {
  TetPatch patch = around(std::array{a, b});
  return make_collapsible(patch, vertices_[a], vertices_[b], kernel);
}

Delta Embedding::commit(const TetPatch& patch) {
  Delta delta = patch.delta(complex().tets.size());
  live_.apply(delta);
  return delta;
}

} // namespace isoscope
