// Pairs of cells with a common face, and the order of cells or pairs by a level: what merge trees are made
// of.
#pragma once

#include "base/parallel.h"

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

/// Asks find(i, links) for the links of each of `count` cells, many at once, and hands them to use(link) in
/// the order of the cells. Some only once the control is cancelled.
template <class Find, class Use>
void for_each_link(std::size_t count, const RunControl& control, const Find& find, const Use& use) {
  constexpr std::size_t cells_by_task = 4096, tasks_at_once = 32;
  std::vector<std::vector<CellLink>> found(tasks_at_once);
  for (std::size_t begin = 0; begin < count; begin += cells_by_task * tasks_at_once) {
    const std::size_t cells = std::min(count - begin, cells_by_task * tasks_at_once),
                      tasks = (cells + cells_by_task - 1) / cells_by_task;
    const bool complete = parallel_until(tasks, 1, control, [&](std::size_t task) {
      found[task].clear();
      const std::size_t first = begin + task * cells_by_task,
                        last = std::min(first + cells_by_task, begin + cells);
      for (std::size_t i = first; i < last; ++i) find(static_cast<std::uint32_t>(i), found[task]);
    });
    if (!complete) return;
    for (std::size_t task = 0; task < tasks; ++task)
      for (const CellLink& link : found[task]) use(link);
  }
}

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
