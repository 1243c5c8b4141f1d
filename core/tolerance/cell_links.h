// Pairs of cells with a common face, and the order of cells or pairs by a level: what merge trees are made
// of.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace isoscope {

struct CellLink {
  std::uint32_t a, b;
};

/// A counting sort by the logarithms of levels, which are not negative: ascending but for a thousandth of the
/// level, equal ones in the order they were in.
template <class Item, class LevelOf> void sort_by_level(std::vector<Item>& items, const LevelOf& level_of) {
  constexpr std::size_t levels = 1 << 13;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Item& item : items) {
    const double v = level_of(item);
    if (v > 0 && std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  }
  if (!(high > low)) return;
  const double scale = (levels - 1) / std::log(high / low);
  std::vector<std::uint16_t> bins(items.size());
  std::vector<std::uint32_t> begin(levels + 1);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double v = std::clamp<double>(level_of(items[i]), low, high);
    bins[i] = static_cast<std::uint16_t>(std::min(scale * std::log(v / low), levels - 1.0));
    ++begin[bins[i] + 1u];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Item> sorted(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) sorted[begin[bins[i]]++] = items[i];
  items = std::move(sorted);
}

} // namespace isoscope
