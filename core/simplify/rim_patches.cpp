// Unites facets of one kind across each edge; Dijkstra's algorithm over vertices.
#include "simplify/rim_patches.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace isoscope {

std::vector<RimPatch> rim_patches(std::span<const RimFacet> facets, std::span<const std::uint8_t> kept) {
  struct Use {
    RimEdge edge;
    std::uint32_t facet;
  };
  std::vector<Use> uses;
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    for (const RimEdge& edge : rim_edges(facets[i])) uses.push_back({edge, i});
  }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& x, const Use& y) { return x.edge < y.edge; });

  DisjointSets sets(facets.size());
  std::vector<Use> borders; // with one of the facets at it, of each kind
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    std::array<const Use*, 2> first{};
    for (; end < uses.size() && uses[end].edge == uses[i].edge; ++end) {
      const Use*& same = first[kept[uses[end].facet]];
      if (same == nullptr) same = &uses[end];
      sets.unite(same->facet, uses[end].facet);
    }
    if (first[0] != nullptr && first[1] != nullptr) borders.insert(borders.end(), {*first[0], *first[1]});
  }

  std::vector<RimPatch> patches;
  std::vector<std::uint32_t> number(facets.size(), 0); // by facet that stands for its set, + 1
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    std::uint32_t& n = number[sets.find(i)];
    if (n == 0) {
      patches.emplace_back().kept = kept[i] != 0;
      n = static_cast<std::uint32_t>(patches.size());
    }
    patches[n - 1].facets.push_back(i);
  }
  for (const Use& use : borders) patches[number[sets.find(use.facet)] - 1].border.push_back(use.edge);
  return patches;
}

std::vector<VertexId> shortest_way(std::span<const RimFacet> facets, std::span<const VertexId> from,
                                   std::span<const VertexId> to,
                                   const std::function<bool(VertexId)>& is_allowed,
                                   const std::function<double(VertexId, VertexId)>& length, double limit) {
  const auto is_end = [&](VertexId v) { return std::binary_search(to.begin(), to.end(), v); };
  std::vector<RimEdge> edges; // both ways
  for (const auto& f : facets)
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = f[k], b = f[(k + 1) % 3];
      edges.push_back({a, b});
      edges.push_back({b, a});
    }
  sort_unique(edges);

  struct Reached {
    double at;
    VertexId before;
    bool done = false;
  };
  std::map<VertexId, Reached> reached;
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const VertexId v : from) {
    reached[v] = {0, VertexId()};
    queue.push({0, v});
  }
  while (!queue.empty()) {
    const auto [at, v] = queue.top();
    queue.pop();
    if (std::exchange(reached[v].done, true)) continue;
    if (is_end(v)) {
      std::vector<VertexId> way{v};
      while (reached[way.back()].before.valid()) way.push_back(reached[way.back()].before);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (auto e = std::lower_bound(edges.begin(), edges.end(), std::array{v, VertexId(0)});
         e != edges.end() && (*e)[0] == v; ++e) {
      const VertexId next = (*e)[1];
      const double there = at + length(v, next);
      if (there > limit || !(is_end(next) || is_allowed(next))) continue;
      const auto found = reached.find(next);
      if (found != reached.end() && found->second.at <= there) continue;
      reached[next] = {there, v};
      queue.push({there, next});
    }
  }
  return {};
}

} // namespace isoscope
