// Pairs of cells with a common face, and their order by a level: what merge trees are made of.
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
template <class LevelOf> void sort_by_level(std::vector<CellLink>& links, const LevelOf& level_of) {
  constexpr std::size_t levels = 1 << 13;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const CellLink& link : links) {
    const double v = level_of(link);
    if (v > 0 && std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  }
  if (!(high > low)) return;
  const double scale = (levels - 1) / std::log(high / low);
  std::vector<std::uint16_t> bins(links.size());
  std::vector<std::uint32_t> begin(levels + 1);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double v = std::clamp<double>(level_of(links[i]), low, high);
    bins[i] = static_cast<std::uint16_t>(std::min(scale * std::log(v / low), levels - 1.0));
    ++begin[bins[i] + 1u];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<CellLink> sorted(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) sorted[begin[bins[i]]++] = links[i];
  links = std::move(sorted);
}

} // namespace isoscope
