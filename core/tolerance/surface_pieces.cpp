// Groups of vertices within some cells, then of those that cells share.
#include "tolerance/surface_pieces.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <span>
#include <utility>

namespace isoscope {
namespace {

/// Where a key is first among sorted vertices; their number where it is not.
template <class Vertices> std::size_t place_of_key(std::uint64_t key, const Vertices& vertices) {
  const auto at = std::lower_bound(vertices.begin(), vertices.end(), key,
                                   [](const auto& v, std::uint64_t k) { return v.key < k; });
  const bool found = at != vertices.end() && at->key == key;
  return found ? static_cast<std::size_t>(at - vertices.begin()) : vertices.size();
}

} // namespace

void SurfacePieces::add(const SurfacePieces& others) {
  for (std::size_t i = 0; i < others.settled_.size(); ++i) {
    Settled v = others.settled_[i];
    v.group += groups_;
    settled_.push_back(v);
  }
  for (std::size_t i = 0; i < others.links_.size(); ++i) links_.push_back(others.links_[i]);
  groups_ += others.groups_;
}

void SurfacePieces::settle() {
  sort_unique(recent_);
  DisjointSets sets(recent_.size());
  for (std::size_t i = 1; i < recent_.size(); ++i)
    if (recent_[i].key == recent_[i - 1].key)
      sets.unite(static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i));
  for (const Link& link : recent_links_) {
    const std::size_t i = place_of_key(link[0], recent_), j = place_of_key(link[1], recent_);
    if (i == recent_.size() || j == recent_.size())
      links_.push_back(link);
    else
      sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  }
  std::vector<std::uint32_t> group(recent_.size());
  for (std::uint32_t i = 0; i < recent_.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    group[i] = root == i ? groups_++ : group[root];
    settled_.push_back({recent_[i].key, group[i], recent_[i].component});
  }
  recent_.clear();
  recent_links_.clear();
}

std::vector<std::size_t> SurfacePieces::count(std::size_t components, const RunControl& control) {
  const std::span<Settled> vertices =
      settled_.size() > 0 ? std::span(&settled_[0], settled_.size()) : std::span<Settled>();
  std::sort(vertices.begin(), vertices.end(),
            [](const Settled& a, const Settled& b) { return a.key < b.key; });
  DisjointSets sets(groups_);
  for (std::size_t i = 1; i < vertices.size(); ++i)
    if (vertices[i].key == vertices[i - 1].key) sets.unite(vertices[i].group, vertices[i - 1].group);
  SparsePoll poll(control);
  for (std::size_t k = 0; k < links_.size() && !poll.cancelled(); ++k) {
    // One to what is no vertex joins nothing.
    const std::size_t i = place_of_key(links_[k][0], vertices), j = place_of_key(links_[k][1], vertices);
    if (i < vertices.size() && j < vertices.size()) sets.unite(vertices[i].group, vertices[j].group);
  }
  std::vector<std::pair<std::uint16_t, std::uint32_t>> pieces;
  for (const Settled& v : vertices) {
    const std::pair piece{v.component, sets.find(v.group)};
    if (pieces.empty() || pieces.back() != piece) pieces.push_back(piece);
  }
  sort_unique(pieces);
  std::vector<std::size_t> counts(components, 0);
  for (const auto& [component, root] : pieces) ++counts[component];
  return counts;
}

} // namespace isoscope
