// Cells in a queue by the lower bound of their error; the error is convex, so its tangent plane at the centre
// bounds it.
#include "collapse/octree_search.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace isoscope {

namespace {

struct Cell {
  Box3 box;
  double bound = 0;
  std::uint32_t order = 0; ///< of creation, against ties
  int depth = 0;
  friend bool operator<(const Cell& a, const Cell& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.order > b.order;
  }
};

double least_cost(const CollapseCost& cost, const Box3& box) {
  const Vec3 c = box.center(), g = cost.gradient(c), e = 0.5 * box.extent();
  return std::max(0.0, cost(c) - std::abs(g.x) * e.x - std::abs(g.y) * e.y - std::abs(g.z) * e.z);
}

bool outside(const Kernel& kernel, const Box3& box) {
  const Vec3 c = box.center(), e = 0.5 * box.extent();
  return std::any_of(kernel.half_spaces.begin(), kernel.half_spaces.end(), [&](const HalfSpace& h) {
    const Vec3 n = h.normal;
    return h.slack(c) + std::abs(n.x) * e.x + std::abs(n.y) * e.y + std::abs(n.z) * e.z <= 0;
  });
}

Box3 octant(const Box3& box, int i) {
  const Vec3 c = box.center();
  return {{i & 1 ? c.x : box.lo.x, i & 2 ? c.y : box.lo.y, i & 4 ? c.z : box.lo.z},
          {i & 1 ? box.hi.x : c.x, i & 2 ? box.hi.y : c.y, i & 4 ? box.hi.z : c.z}};
}

/// What to do with a cell; its centre is judged on the way.
OctreeCell::Fate visit(TargetTrial& trial, const Cell& cell, const TargetSearchOptions& options) {
  if (trial.found() && cell.bound >= trial.found_cost()) return OctreeCell::Fate::costlier;
  if (outside(trial.kernel(), cell.box)) return OctreeCell::Fate::outside_kernel;
  if (trial.invalid(cell.box)) return OctreeCell::Fate::invalid;
  const Vec3 c = cell.box.center();
  const double cost = trial.cost()(c);
  if ((!trial.found() || cost < trial.found_cost()) && trial.plausible(c))
    trial.judge(c, cost, Reason::octree_search);
  return cell.depth < options.octree_depth ? OctreeCell::Fate::split : OctreeCell::Fate::last_level;
}

} // namespace

void search_octree(TargetTrial& trial, const TargetSearchOptions& options) {
  const KernelPolyhedron polyhedron = kernel_polyhedron(trial.kernel());
  Cell root;
  for (const Vec3 v : polyhedron.vertices) root.box.add(v);
  if (root.box.empty()) return;
  root.bound = least_cost(trial.cost(), root.box);
  std::uint32_t created = 0;
  std::priority_queue<Cell> queue;
  queue.push(root);
  while (!queue.empty() && trial.tried() < static_cast<std::uint32_t>(std::max(options.octree_samples, 0))) {
    const Cell cell = queue.top();
    queue.pop();
    const OctreeCell::Fate fate = visit(trial, cell, options);
    trial.visit({cell.box, fate});
    if (fate != OctreeCell::Fate::split) continue;
    for (int i = 0; i < 8; ++i) {
      const Box3 part = octant(cell.box, i);
      queue.push({part, std::max(cell.bound, least_cost(trial.cost(), part)), ++created, cell.depth + 1});
    }
  }
}

} // namespace isoscope
