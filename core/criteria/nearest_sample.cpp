// Balanced kd-trees stored as permutations: the median of a range splits it, short ranges are searched
// through.
#include "criteria/nearest_sample.h"

#include "base/parallel.h"

namespace isoscope {
namespace {

constexpr std::size_t leaf_size = 8;
constexpr std::size_t parallel_build_size = 50000;

struct Best {
  double squared_distance = std::numeric_limits<double>::infinity();
  std::uint32_t sample = SampleId::none;

  void offer(double d, std::uint32_t s) {
    if (d < squared_distance || (d == squared_distance && s < sample)) {
      squared_distance = d;
      sample = s;
    }
  }
};

struct Searcher {
  std::span<const Vec3> positions;
  std::span<const std::uint32_t> order;
  std::span<const std::uint8_t> axis;
  Vec3 query;

  void visit(std::size_t begin, std::size_t end, Best& best) const {
    if (end - begin <= leaf_size) {
      for (std::size_t i = begin; i < end; ++i) offer(i, best);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    offer(middle, best);
    const int a = axis[middle];
    const double offset = query[a] - positions[order[middle]][a];
    const bool left_first = offset < 0;
    if (left_first)
      visit(begin, middle, best);
    else
      visit(middle + 1, end, best);
    if (offset * offset > best.squared_distance) return;
    if (left_first)
      visit(middle + 1, end, best);
    else
      visit(begin, middle, best);
  }

  void offer(std::size_t i, Best& best) const {
    best.offer(squared_length(positions[order[i]] - query), order[i]);
  }
};

int longest_axis(Vec3 extent) {
  int a = extent.y > extent.x ? 1 : 0;
  return extent.z > extent[a] ? 2 : a;
}

} // namespace

NearestSample::NearestSample(std::span<const Vec3> positions, std::span<const std::int8_t> labels)
    : positions_(positions) {
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    (labels[i] > 0 ? positive_ : negative_).order.push_back(i);
  }
  for (Tree* tree : {&positive_, &negative_}) {
    tree->axis.resize(tree->order.size());
    build(*tree, 0, tree->order.size());
  }
}

void NearestSample::build(Tree& tree, std::size_t begin, std::size_t end) {
  if (end - begin <= leaf_size) return;
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) box.add(positions_[tree.order[i]]);
  const int a = longest_axis(box.extent());
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return tree.order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
    const double x = positions_[i][a], y = positions_[j][a];
    return x < y || (x == y && i < j);
  });
  tree.axis[middle] = static_cast<std::uint8_t>(a);
  const auto half = [&](std::size_t which) {
    if (which == 0)
      build(tree, begin, middle);
    else
      build(tree, middle + 1, end);
  };
  parallel_for(2, end - begin >= parallel_build_size ? 1 : 2, half);
}

SampleId NearestSample::search(const Tree& tree, Vec3 p) const {
  Best best;
  Searcher{positions_, tree.order, tree.axis, p}.visit(0, tree.order.size(), best);
  return SampleId(best.sample);
}

SampleId NearestSample::nearest(Vec3 p) const {
  const SampleId a = search(positive_, p), b = search(negative_, p);
  if (!a.valid() || !b.valid()) return a.valid() ? a : b;
  Best best;
  for (const SampleId s : {a, b}) best.offer(squared_length(positions_[s.index()] - p), s.value);
  return SampleId(best.sample);
}

SampleId NearestSample::nearest(Vec3 p, int label) const {
  return search(label > 0 ? positive_ : negative_, p);
}

std::size_t NearestSample::memory_bytes() const {
  std::size_t bytes = 0;
  for (const Tree* tree : {&positive_, &negative_}) {
    bytes += tree->order.capacity() * sizeof(std::uint32_t) + tree->axis.capacity();
  }
  return bytes;
}

} // namespace isoscope
