// Balanced bounding box trees stored as permutations: each range is halved at the median of its longest axis.
#include "criteria/nearest_sample.h"

#include "base/parallel.h"

#include <utility>

namespace isoscope {
namespace {

constexpr std::size_t leaf_size = 12;
constexpr std::size_t parallel_build_size = 50000;

int longest_axis(Vec3 extent) {
  const int a = extent.y > extent.x ? 1 : 0;
  return extent.z > extent[a] ? 2 : a;
}

/// Squared distances of p to two boxes.
std::pair<double, double> squared_distances(const Box3& a, const Box3& b, Vec3 p) {
  double to_a = 0, to_b = 0;
  for (int i = 0; i < 3; ++i) {
    const double x = std::max(std::max(a.lo[i] - p[i], p[i] - a.hi[i]), 0.0),
                 y = std::max(std::max(b.lo[i] - p[i], p[i] - b.hi[i]), 0.0);
    to_a += x * x;
    to_b += y * y;
  }
  return {to_a, to_b};
}

} // namespace

struct NearestSample::Best {
  double squared_distance = Box3::inf;
  std::uint32_t sample = SampleId::none;

  void offer(double d, std::uint32_t s) {
    if (d < squared_distance || (d == squared_distance && s < sample)) {
      squared_distance = d;
      sample = s;
    }
  }
};

struct NearestSample::Range {
  std::size_t node = 0, begin = 0, end = 0;

  bool leaf() const { return end - begin <= leaf_size; }
  Range left() const { return {2 * node + 1, begin, begin + (end - begin) / 2}; }
  Range right() const { return {2 * node + 2, begin + (end - begin) / 2, end}; }
};

NearestSample::NearestSample(std::span<const Vec3> positions, std::span<const std::int8_t> labels)
    : positions_(positions), sides_(2) {
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::size_t side = place_of(labels[i]);
    if (side >= sides_.size()) sides_.resize(side + 1);
    sides_[side].order.push_back(i);
  }
  for (Tree& tree : sides_) {
    std::size_t nodes = 1;
    for (std::size_t size = tree.order.size(); size > leaf_size; size = size - size / 2)
      nodes = 2 * nodes + 1;
    tree.boxes.resize(nodes);
    build(tree, {0, 0, tree.order.size()});
  }
}

void NearestSample::build(Tree& tree, const Range& range) {
  Box3& box = tree.boxes[range.node];
  for (std::size_t i = range.begin; i < range.end; ++i) box.add(positions_[tree.order[i]]);
  if (range.leaf()) return;
  const int a = longest_axis(box.extent());
  const auto at = [&](std::size_t i) { return tree.order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(range.begin), at(range.left().end), at(range.end),
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double x = positions_[i][a], y = positions_[j][a];
                     return x < y || (x == y && i < j);
                   });
  const std::size_t grain = range.end - range.begin >= parallel_build_size ? 1 : 2;
  parallel_for(2, grain, [&](std::size_t half) { build(tree, half == 0 ? range.left() : range.right()); });
}

void NearestSample::search(const Tree& tree, const Range& range, Vec3 p, Best& best) const {
  if (range.leaf()) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      best.offer(squared_length(positions_[tree.order[i]] - p), tree.order[i]);
    }
    return;
  }
  Range near = range.left(), far = range.right();
  auto [to_near, to_far] = squared_distances(tree.boxes[near.node], tree.boxes[far.node], p);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  if (to_near <= best.squared_distance) search(tree, near, p, best);
  if (to_far <= best.squared_distance) search(tree, far, p, best);
}

SampleId NearestSample::nearest(Vec3 p, double radius) const {
  Best best{radius * radius, SampleId::none};
  for (const Tree& tree : sides_) search(tree, {0, 0, tree.order.size()}, p, best);
  return SampleId(best.sample);
}

SampleId NearestSample::nearest_of(Vec3 p, int label, double radius) const {
  if (!has(label)) return {};
  const Tree& tree = sides_[place_of(label)];
  Best best{radius * radius, SampleId::none};
  search(tree, {0, 0, tree.order.size()}, p, best);
  return SampleId(best.sample);
}

std::size_t NearestSample::memory_bytes() const {
  std::size_t bytes = 0;
  for (const Tree& tree : sides_) {
    bytes += tree.order.capacity() * sizeof(std::uint32_t) + tree.boxes.capacity() * sizeof(Box3);
  }
  return bytes;
}

} // namespace isoscope
