// Unites cells whose faces meet, and steps away from what is nearest.
#include "tolerance/deep_cells.h"

#include "tolerance/cell_links.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace isoscope {
namespace {

constexpr int climb_steps = 60;

} // namespace

DeepCells::DeepCells(const Regions& octree, double delta, const Box3& within, const RunControl& control)
    : octree_(octree), delta_(delta), within_(within), parent_(octree.size()) {
  std::iota(parent_.begin(), parent_.end(), 0u);
  const auto find_links = [this](CellIndex i, std::vector<CellLink>& links) {
    if (!deep(i)) return;
    const Regions::Cell c = octree_.cell(i);
    for (int face = 0; face < 6; ++face) {
      // Of two one tells: the smaller, or of the same size the one before.
      const CellIndex n = octree_.neighbor(c, face);
      if (n == Regions::none || (face % 2 == 0 && octree_.cell(n).level == c.level) || !deep(n)) continue;
      links.push_back({i, n});
    }
  };
  for_each_link(octree.size(), control, find_links, [this](const CellLink& l) { unite(l.a, l.b); });
}

bool DeepCells::joined(Vec3 p) const {
  const CellIndex i = octree_.locate(p);
  if (i == Regions::none) return true;
  if (!deep(i)) return false;
  const Regions::Cell c = octree_.cell(i);
  return distance(p, octree_.center(c)) < static_cast<double>(c.distance) - delta_;
}

std::vector<DeepCells::CellIndex> DeepCells::deepest(const RunControl& control) const {
  std::map<CellIndex, CellIndex> best;
  SparsePoll poll(control);
  for (CellIndex i = 0; i < octree_.size() && !poll.cancelled(); ++i) {
    if (!deep(i)) continue;
    const auto [at, fresh] = best.emplace(group(i), i);
    if (!fresh && octree_.distance(i) > octree_.distance(at->second)) at->second = i;
  }
  std::vector<CellIndex> cells;
  for (const auto& [root, cell] : best) cells.push_back(cell);
  return cells;
}

void DeepCells::unite(CellIndex a, CellIndex b) {
  a = group(a);
  b = group(b);
  parent_[std::max(a, b)] = std::min(a, b);
  // Halves the way for the next one.
  while (parent_[parent_[std::max(a, b)]] != parent_[std::max(a, b)]) {
    parent_[std::max(a, b)] = parent_[parent_[std::max(a, b)]];
  }
}

bool climb(const ToleranceField& field, const DeepCells& cells, double delta, ClosestPoint at, Vec3& p,
           double& depth) {
  depth = at.distance();
  for (int step = 0; step < climb_steps; ++step) {
    if (cells.joined(p)) return true;
    const double radius = 0.99 * (at.distance() - delta);
    const Vec3 q = p + radius * normalized(p - at.point);
    if (!cells.holds(q)) break;
    const ClosestPoint next = field.closest_near(q, at.triangle);
    if (next.distance() <= at.distance() + 1e-3 * radius) break;
    p = q;
    at = next;
    depth = at.distance();
  }
  return cells.joined(p);
}

} // namespace isoscope
