// Sides of regions by how deep they are and by what they are joined to as δ shrinks.
#include "base/disjoint_sets.h"
#include "tolerance/cell_links.h"
#include "tolerance/delta_study.h"
#include "tolerance/region_labels.h"
#include "tolerance/regions.h"

#include <algorithm>
#include <deque>

namespace isoscope {
namespace {

/// Alternating labels of deep regions from the unbounded one; those that no way over components of Ω' leads
/// to are inside. Others have 0.
std::vector<int> label_deep_regions(const ToleranceVolume& volume) {
  const std::size_t n = volume.regions().size();
  const double enough = deep_enough * volume.thresholds().delta;
  const auto is_deep = [&](RegionId r) {
    const Region& region = volume.regions()[r.index()];
    return region.unbounded || region.depth > enough;
  };
  std::vector<std::vector<RegionId>> around(volume.volume_component_count());
  std::vector<std::vector<std::uint32_t>> components(n);
  for (const BoundaryComponent& c : volume.boundary_components()) {
    around[c.volume_component].push_back(c.region);
    components[c.region.index()].push_back(c.volume_component);
  }
  std::vector<int> labels(n);
  std::deque<RegionId> queue{RegionId(0)};
  labels[0] = +1;
  while (!queue.empty()) {
    const RegionId from = queue.front();
    queue.pop_front();
    for (const std::uint32_t c : components[from.index()])
      for (const RegionId to : around[c]) {
        if (labels[to.index()] != 0 || !is_deep(to)) continue;
        labels[to.index()] = -labels[from.index()];
        queue.push_back(to);
      }
  }
  for (std::size_t r = 0; r < n; ++r)
    if (labels[r] == 0 && is_deep(RegionId(r))) labels[r] = -1;
  return labels;
}

} // namespace

DepthLabels label_by_depth(const ToleranceVolume& volume, const RunControl& control) {
  return spread_labels(volume, label_deep_regions(volume), control);
}

DepthLabels spread_labels(const ToleranceVolume& volume, std::vector<int> of_regions,
                          const RunControl& control) {
  DepthLabels labels;
  labels.of_regions = std::move(of_regions);
  for (const int label : labels.of_regions) labels.shallow.push_back(label == 0);

  // Leaves are joined in the order in which {φ > r} joins them as r shrinks, but for those of deep regions,
  // which keep what joined them first.
  const Regions& octree = volume.octree();
  std::vector<CellLink> links = octree.leaf_links(control);
  const auto level = [&](const CellLink& link) {
    return static_cast<double>(std::min(octree.distance(link.a), octree.distance(link.b)));
  };
  sort_by_level(links, level);
  DisjointSets basins(octree.size());
  labels.of_cells.assign(octree.size(), 0);
  for (std::size_t i = 0; i < octree.size(); ++i) {
    const auto cell = static_cast<Regions::CellIndex>(i);
    if (octree.kind(cell) != Regions::Kind::out) continue;
    if (const auto number = octree.number(cell))
      labels.of_cells[i] = static_cast<std::int8_t>(labels.of_regions[*number]);
  }
  SparsePoll poll(control);
  for (std::size_t i = links.size(); i-- > 0 && !poll.cancelled();) {
    const std::uint32_t a = basins.find(links[i].a), b = basins.find(links[i].b);
    const std::int8_t of_a = labels.of_cells[a], of_b = labels.of_cells[b];
    if (a == b || (of_a != 0 && of_b != 0 && of_a != of_b)) continue;
    basins.unite(a, b);
    labels.of_cells[basins.find(a)] = of_a != 0 ? of_a : of_b;
  }
  for (std::size_t i = 0; i < octree.size(); ++i)
    labels.of_cells[i] = labels.of_cells[basins.find(static_cast<std::uint32_t>(i))];
  for (std::size_t r = 0; r < labels.of_regions.size(); ++r) {
    int& label = labels.of_regions[r];
    if (label != 0) continue;
    const Regions::CellIndex at = octree.locate(volume.regions()[r].deepest);
    label = at != Regions::none && labels.of_cells[at] < 0 ? labels.of_cells[at] : +1;
  }
  return labels;
}

} // namespace isoscope
