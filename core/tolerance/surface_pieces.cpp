// Groups of vertices within some cells, then of those that cells share.
#include "tolerance/surface_pieces.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <span>

namespace isoscope {

void SurfacePieces::add(const SurfacePieces& others) {
  for (std::size_t i = 0; i < others.shared_.size(); ++i) {
    Shared v = others.shared_[i];
    v.group += groups_;
    shared_.push_back(v);
  }
  for (std::size_t i = 0; i < others.links_.size(); ++i) links_.push_back(others.links_[i]);
  for (const auto& [component, group] : others.groups_by_component_)
    groups_by_component_.emplace_back(component, group + groups_);
  groups_ += others.groups_;
}

std::vector<std::size_t> SurfacePieces::count(std::size_t components, const RunControl& control) {
  const std::span<Shared> vertices =
      shared_.size() > 0 ? std::span(&shared_[0], shared_.size()) : std::span<Shared>();
  const auto by_key = [](const Shared& a, const Shared& b) { return a.key < b.key; };
  std::sort(vertices.begin(), vertices.end(), by_key);
  DisjointSets sets(groups_);
  SparsePoll poll(control);
  for (std::size_t k = 0; k < links_.size() && !poll.cancelled(); ++k) {
    // One to what is no vertex joins nothing.
    const auto a = std::lower_bound(vertices.begin(), vertices.end(), Shared{links_[k][0], 0}, by_key);
    const auto b = std::lower_bound(vertices.begin(), vertices.end(), Shared{links_[k][1], 0}, by_key);
    if (a != vertices.end() && b != vertices.end() && a->key == links_[k][0] && b->key == links_[k][1])
      sets.unite(a->group, b->group);
  }
  std::vector<std::pair<std::uint16_t, std::uint32_t>> pieces = groups_by_component_;
  for (auto& [component, group] : pieces) group = sets.find(group);
  sort_unique(pieces);
  std::vector<std::size_t> counts(components, 0);
  for (const auto& [component, root] : pieces) ++counts[component];
  return counts;
}

void PiecesOfBlock::add(Vertex v, std::uint16_t component) {
  node_[v] = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({v, component});
}

SurfacePieces
PiecesOfBlock::settled(const std::function<SurfacePieces::Place(std::uint32_t corner)>& place_of) const {
  const auto key_of = [&](Vertex v) {
    const auto [x, y, z] = place_of(v / slots_at_corner);
    constexpr unsigned bits = SurfacePieces::place_bits;
    return std::uint64_t{v % slots_at_corner} << (3 * bits) | std::uint64_t{z} << (2 * bits) |
           std::uint64_t{y} << bits | std::uint64_t{x};
  };
  SurfacePieces pieces;
  DisjointSets sets(nodes_.size());
  std::vector<std::uint8_t> is_shared(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    is_shared[i] = cells_[nodes_[i].vertex / slots_at_corner] < cells_at_corner ? 1 : 0;
  for (const auto& [a, b] : links_) {
    const std::uint32_t i = node_[a], j = node_[b];
    if (i != none && j != none) {
      sets.unite(i, j);
      continue;
    }
    for (const std::uint32_t k : {i, j})
      if (k != none) is_shared[k] = 1;
    pieces.links_.push_back({key_of(a), key_of(b)});
  }
  std::vector<std::uint32_t> group(nodes_.size());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const std::uint32_t root = sets.find(i); // the smallest, so that it has a group
    group[i] = root == i ? pieces.groups_++ : group[root];
    if (root == i || nodes_[i].component != nodes_[root].component)
      pieces.groups_by_component_.emplace_back(nodes_[i].component, group[i]);
    if (is_shared[i] != 0) pieces.shared_.push_back({key_of(nodes_[i].vertex), group[i]});
  }
  return pieces;
}

} // namespace isoscope
