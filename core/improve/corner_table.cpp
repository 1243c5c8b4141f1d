// Opposite corners are found among the edges that have their lower end in common.
#include "improve/corner_table.h"

#include <algorithm>

namespace isoscope {

CornerTable::CornerTable(std::span<const std::array<std::uint32_t, 3>> facets, std::size_t vertices)
    : opposite_(3 * facets.size(), none), corner_(vertices, none) {
  vertex_.reserve(3 * facets.size());
  for (const auto& f : facets) vertex_.insert(vertex_.end(), f.begin(), f.end());
  // Of the edge that a corner faces: the lower and the higher end.
  const auto ends = [&](std::uint32_t c) { return std::minmax(vertex_[next(c)], vertex_[previous(c)]); };
  std::vector<std::uint32_t> first(vertices + 1, 0), faced(vertex_.size());
  const auto count = static_cast<std::uint32_t>(vertex_.size());
  for (std::uint32_t c = 0; c < count; ++c) ++first[ends(c).first + 1];
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  for (std::uint32_t c = count; c-- > 0;) faced[--first[ends(c).first + 1]] = c;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::span<const std::uint32_t> own(faced.data() + first[v + 1],
                                             (v + 1 < vertices ? first[v + 2] : count) - first[v + 1]);
    for (const std::uint32_t c : own) {
      std::uint32_t found = none, uses = 0;
      for (const std::uint32_t d : own)
        if (d != c && ends(d).second == ends(c).second) found = d, ++uses;
      if (uses == 1 && vertex_[next(c)] == vertex_[previous(found)]) opposite_[c] = found;
    }
  }
  for (std::uint32_t c = 0; c < count; ++c) corner_[vertex_[c]] = c;
}

void CornerTable::star(std::uint32_t v, std::vector<std::uint32_t>& corners) const {
  corners.clear();
  const std::uint32_t begin = corner_[v];
  if (begin == none) return;
  std::uint32_t c = begin;
  do {
    corners.push_back(c);
    const std::uint32_t across = opposite_[next(c)];
    if (across == none) return corners.clear();
    c = next(across);
  } while (c != begin);
}

void CornerTable::join(std::uint32_t a, std::uint32_t b) {
  if (a != none) opposite_[a] = b;
  if (b != none) opposite_[b] = a;
}

void CornerTable::collapse(std::uint32_t c) {
  const std::uint32_t stays = vertex_[next(c)];
  std::vector<std::uint32_t> corners;
  star(vertex_[c], corners);
  const std::uint32_t goes = vertex_[c];
  // The facets on the two sides of the edge: (goes, stays, left) and (goes, right, stays).
  const std::uint32_t left = c, right = previous(opposite_[previous(c)]);
  const std::uint32_t after_left = opposite_[next(left)], before_right = opposite_[previous(right)];
  join(opposite_[left], after_left);
  join(opposite_[right], before_right);
  for (const std::uint32_t at : corners) vertex_[at] = stays;
  corner_[goes] = none;
  corner_[stays] = next(after_left);
  corner_[vertex_[previous(left)]] = previous(after_left);
  corner_[vertex_[next(right)]] = next(before_right);
  for (const std::uint32_t f : {left / 3, right / 3})
    for (std::uint32_t k = 0; k < 3; ++k) vertex_[3 * f + k] = opposite_[3 * f + k] = none;
}

} // namespace isoscope
