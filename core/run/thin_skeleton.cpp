// Floods the lattice over the walls in rounds, then goes from the roots by the shortest ways.
#include "run/thin_skeleton.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "run/touching_ball.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace isoscope {
namespace {

/// Side of the lattice's cells in units of δ'. Neighbouring middles are then mostly near enough for a
/// Delaunay edge: a ball over an edge of length δ' holds no sample, which are δ' away from the input.
constexpr double cell_side = 0.35;
/// Where what is thin is so large that there are too many of those: at most.
constexpr double coarsest_cell_side = 1, coarser = 1.25;
/// The walls that were asked for take at most this part of the nodes; the rest is for the way to a region.
constexpr double share_of_start = 0.4;
/// Middles farther apart than this, in units of δ', are not joined: at the foot of a fin the ball grows at
/// once.
constexpr double longest_straight_link = 2.2;
/// The same where the input lies between them, if their middle is no farther outside than `slip`.
constexpr double longest_link = 1.8, slip = 0.25;
/// A ball this large, in units of δ', reaches the region itself.
constexpr double root_radius = 0.98;
/// A link through a wall counts as so many times its length: thin curved shells have no others.
constexpr double price_of_walls = 200;
/// What is thin is looked at up to so many cells.
constexpr std::size_t most_nodes = 600000;
constexpr std::size_t node_grain = 16;

template <class Visit> void for_neighbors(const LatticeCell& cell, const Visit& visit) {
  for (std::int64_t x = -1; x <= 1; ++x)
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) visit(LatticeCell{cell[0] + x, cell[1] + y, cell[2] + z});
}

} // namespace

ThinSkeleton::ThinSkeleton(const ToleranceVolume& volume, const InputWalls& walls, int label,
                           std::span<const Vec3> from, std::span<const Vec3> ends, const RunControl& control)
    : volume_(volume), walls_(walls), label_(label), side_(cell_side * volume.thresholds().boundary),
      origin_(volume.index().bounds().lo) {
  std::vector<Vec3> all(from.begin(), from.end());
  all.insert(all.end(), ends.begin(), ends.end());
  grow(all, control);
  find_ways(ends, control);
}

std::uint32_t ThinSkeleton::node_at(Vec3 p) const {
  const auto found = cells_.find(cell_at(p));
  if (found == cells_.end() || !nodes_[found->second].usable) return none;
  return found->second;
}

ThinSkeleton::Node ThinSkeleton::make_node(const Cell& cell) const {
  Node node;
  Vec3 center;
  for (int i = 0; i < 3; ++i)
    center[i] = origin_[i] + (static_cast<double>(cell[static_cast<std::size_t>(i)]) + 0.5) * side_;
  const ClosestPoint closest = volume_.index().closest_within(center, 0.87 * side_);
  if (!closest.triangle.valid()) return node;
  const Triangle3& wall = volume_.index().triangle(closest.triangle);
  const Vec3 normal = normalized(area_vector(wall));
  if (normal == Vec3{}) return node;
  const WallVerdict verdict = walls_.judge(closest.triangle, closest.point, normal);
  const double boundary = volume_.thresholds().boundary;
  const auto largest = [&](Vec3 direction) {
    return touching_radius(closest.point, direction, boundary,
                           [&](Vec3 p) { return volume_.index().closest(p).point; });
  };
  double radius = 0;
  if (verdict.bounds(label_)) {
    const Vec3 direction = (verdict.outward > 0) == (label_ > 0) ? normal : -normal;
    radius = largest(direction);
    node.middle = closest.point + radius * direction;
  } else if (verdict.kind == Wall::inner && volume_.sides().known()) {
    // The way leads through what is a wall within the side only, as where parts overlap.
    const double front = largest(normal), back = largest(-normal);
    radius = std::max(front, back);
    node.middle = closest.point + (front >= back ? front : -back) * normal;
    if (volume_.sides().label(node.middle) != label_) return node;
  } else {
    return node;
  }
  node.usable = true;
  node.root = radius >= root_radius * boundary;
  return node;
}

std::vector<ThinSkeleton::Cell> ThinSkeleton::start(std::span<const Vec3> from) {
  const double coarsest = coarsest_cell_side * volume_.thresholds().boundary;
  for (;; side_ = std::min(side_ * coarser, coarsest)) {
    std::vector<Cell> cells;
    for (const Vec3 p : from) cells.push_back(cell_at(p));
    sort_unique(cells);
    if (static_cast<double>(cells.size()) <= share_of_start * most_nodes || side_ >= coarsest) return cells;
  }
}

void ThinSkeleton::grow(std::span<const Vec3> from, const RunControl& control) {
  std::vector<Cell> round = start(from);
  while (!round.empty() && nodes_.size() < most_nodes && !control.cancelled()) {
    sort_unique(round);
    std::erase_if(round, [&](const Cell& c) { return cells_.contains(c); });
    std::vector<Node> made(round.size());
    if (!parallel_until(round.size(), node_grain, control,
                        [&](std::size_t i) { made[i] = make_node(round[i]); }))
      return;
    std::vector<Cell> next;
    for (std::size_t i = 0; i < round.size(); ++i) {
      cells_.emplace(round[i], static_cast<std::uint32_t>(nodes_.size()));
      cell_of_.push_back(round[i]);
      nodes_.push_back(made[i]);
      if (made[i].usable && !made[i].root) for_neighbors(round[i], [&](const Cell& c) { next.push_back(c); });
    }
    round = std::move(next);
  }
}

/// Whether the middle between two points lies far on the other side.
bool ThinSkeleton::strays(Vec3 a, Vec3 b) const {
  const Vec3 middle = 0.5 * (a + b);
  return volume_.index().distance(middle) > slip * volume_.thresholds().boundary &&
         volume_.sides().label(middle) != label_;
}

void ThinSkeleton::find_ways(std::span<const Vec3> ends, const RunControl& control) {
  std::vector<std::uint32_t> roots;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n)
    if (nodes_[n].root) roots.push_back(n);
  spread(std::move(roots), control);
  for (const Vec3 p : ends) {
    const std::uint32_t n = node_at(p);
    if (n == none || nodes_[n].way < Box3::inf) continue;
    nodes_[n].root = nodes_[n].end = true;
    spread({n}, control);
  }
}

/// Dijkstra's shortest ways; of equal ones that to the smaller node comes first.
void ThinSkeleton::spread(std::vector<std::uint32_t> roots, const RunControl& control) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const std::uint32_t n : roots) {
    nodes_[n].way = 0;
    open.emplace(0.0, n);
  }
  const double boundary = volume_.thresholds().boundary;
  SparsePoll poll(control, 64);
  while (!open.empty() && !poll.cancelled()) {
    const auto [way, n] = open.top();
    open.pop();
    if (way > nodes_[n].way) continue;
    for_neighbors(cell_of_[n], [&](const Cell& c) {
      const auto found = cells_.find(c);
      if (found == cells_.end()) return;
      Node& other = nodes_[found->second];
      const double link = distance(nodes_[n].middle, other.middle);
      if (!other.usable || other.root || link > longest_straight_link * boundary || way + link >= other.way)
        return;
      const bool inside = volume_.index().crossings(nodes_[n].middle, other.middle).empty();
      if (!inside && (link > longest_link * boundary || strays(nodes_[n].middle, other.middle))) return;
      const double longer = way + (inside ? link : price_of_walls * link);
      if (longer >= other.way) return;
      other.way = longer;
      other.parent = n;
      other.straight = inside;
      open.emplace(longer, found->second);
    });
  }
}

} // namespace isoscope
