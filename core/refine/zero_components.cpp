// Compares how the pieces of Z inside of a change are joined to what is around it.
#include "refine/zero_components.h"

#include "base/disjoint_sets.h"
#include "base/sort_unique.h"
#include "refine/simplices.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// Whether t and its neighbour across from vertex i have a part of Z in common.
bool joined_across(const TetLabels& labels, std::size_t i) {
  const std::int8_t a = labels[(i + 1) % 4];
  return labels[(i + 2) % 4] != a || labels[(i + 3) % 4] != a;
}

} // namespace

std::size_t ZeroComponents::count(const Complex& complex, const Delaunay& delaunay) {
  if (known_) return *known_;
  std::size_t components = 0;
  std::vector<bool> seen(complex.tets.size(), false);
  std::vector<TetId> front;
  for (std::uint32_t i = 0; i < complex.tets.size(); ++i) {
    if (seen[i] || !complex.tets[i].alive() || !carries_zero_set(complex.labels(TetId(i)))) continue;
    ++components;
    seen[i] = true;
    front.push_back(TetId(i));
    while (!front.empty()) {
      const TetId t = front.back();
      front.pop_back();
      const TetLabels labels = complex.labels(t);
      const std::array<TetId, 4> neighbours = delaunay.neighbours(t);
      for (std::size_t k = 0; k < 4; ++k) {
        const TetId n = neighbours[k];
        if (!n.valid() || seen[n.index()] || !joined_across(labels, k)) continue;
        seen[n.index()] = true;
        front.push_back(n);
      }
    }
  }
  known_ = components;
  return components;
}

ZeroComponents::Pieces ZeroComponents::pieces(const Complex& complex, std::span<const TetRecord> tets) {
  Pieces found;
  std::vector<Crossing> by_tet; // each with the number of its tetrahedron
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    const auto& v = tets[t].v;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (complex.label(v[i]) != complex.label(v[j])) by_tet.emplace_back(packed(v[i], v[j]), t);
  }
  std::sort(by_tet.begin(), by_tet.end());
  DisjointSets sets(tets.size());
  std::vector<bool> carries(tets.size(), false);
  for (std::size_t k = 0; k < by_tet.size(); ++k) {
    carries[by_tet[k].second] = true;
    if (k > 0 && by_tet[k].first == by_tet[k - 1].first) sets.unite(by_tet[k].second, by_tet[k - 1].second);
  }
  for (std::uint32_t t = 0; t < tets.size(); ++t)
    if (carries[t] && sets.find(t) == t) ++found.count;
  for (const auto& [edge, t] : by_tet)
    if (found.crossings.empty() || found.crossings.back().first != edge)
      found.crossings.emplace_back(edge, sets.find(t));
  return found;
}

void ZeroComponents::replace(const Complex& complex, std::span<const TetRecord> removed,
                             std::span<const TetRecord> added) {
  if (!known_) return;
  const Pieces before = pieces(complex, removed), after = pieces(complex, added);
  // What both have is where Z goes on outside.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
  for (auto b = before.crossings.begin(), a = after.crossings.begin();
       b != before.crossings.end() && a != after.crossings.end();) {
    if (b->first == a->first)
      links.emplace_back(b++->second, a++->second);
    else
      b->first < a->first ? ++b : ++a;
  }
  sort_unique(links);
  std::vector<std::uint32_t> fronts, backs;
  for (const auto& [b, a] : links) {
    fronts.push_back(b);
    backs.push_back(a);
  }
  sort_unique(fronts);
  sort_unique(backs);
  if (fronts.size() != links.size() || backs.size() != links.size()) return known_.reset();
  // Each goes on as one; the others are components for themselves.
  *known_ += after.count;
  *known_ -= before.count;
}

} // namespace isoscope
