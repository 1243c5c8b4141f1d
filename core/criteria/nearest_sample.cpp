// Balanced box trees stored as permutations: each range is quartered, twice at the median of its longest
// axis.
#include "criteria/nearest_sample.h"

#include "base/parallel.h"
#include "tolerance/box_search.h"

#include <algorithm>
#include <limits>

namespace isoscope {
namespace {

constexpr std::size_t leaf_size = 16, lane_count = BoxHierarchy::width;
constexpr std::size_t parallel_build_size = 50000;

int longest_axis(Vec3 extent) {
  const int a = extent.y > extent.x ? 1 : 0;
  return extent.z > extent[a] ? 2 : a;
}

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
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

/// Orders the samples of one side.
class NearestSample::Builder {
 public:
  Builder(std::span<const Vec3> positions, Tree& tree) : positions_(positions), tree_(tree) {}

  void build() {
    BoxHierarchy& boxes = tree_.boxes;
    const std::size_t count = boxes.ids.size();
    boxes.bounds = box_of(0, count);
    boxes.origin = count > 0 ? boxes.bounds.center() : Vec3{};
    const double scale = boxes.bounds.longest_edge();
    boxes.inverse_scale = count > 0 && scale > 0 && std::isfinite(1 / scale) ? 1 / scale : 1;
    std::size_t nodes = 1;
    for (std::size_t size = (count + 3) / 4; size > leaf_size; size = (size + 3) / 4) nodes = 4 * nodes + 1;
    boxes.nodes.resize(nodes);
    fill(0, 0, count, boxes.bounds);
    boxes.nodes.shrink_to_fit();
    for (std::size_t a = 0; a < 3; ++a) {
      tree_.rough[a].resize(count + lane_count - 1);
      for (std::size_t i = 0; i < count; ++i)
        tree_.rough[a][i] = static_cast<float>(in_frame(positions_[boxes.ids[i]], static_cast<int>(a)));
    }
  }

 private:
  Box3 box_of(std::size_t begin, std::size_t end) const {
    Box3 box;
    for (std::size_t i = begin; i < end; ++i) box.add(positions_[tree_.boxes.ids[i]]);
    return box;
  }
  double in_frame(Vec3 p, int axis) const {
    return (p[axis] - tree_.boxes.origin[axis]) * tree_.boxes.inverse_scale;
  }
  std::size_t halve(std::size_t begin, std::size_t end, const Box3& box) {
    const int a = longest_axis(box.extent());
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return tree_.boxes.ids.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
      const double x = positions_[i][a], y = positions_[j][a];
      return x < y || (x == y && i < j);
    });
    return middle;
  }
  void fill(std::size_t node, std::size_t begin, std::size_t end, const Box3& own) {
    const std::size_t middle = halve(begin, end, own);
    const std::array<std::size_t, 5> ends{begin, halve(begin, middle, box_of(begin, middle)), middle,
                                          halve(middle, end, box_of(middle, end)), end};
    BoxHierarchy::Node& n = tree_.boxes.nodes[node];
    const std::size_t grain = end - begin >= parallel_build_size ? 1 : lane_count;
    parallel_for(lane_count, grain, [&](std::size_t k) {
      const std::size_t size = ends[k + 1] - ends[k];
      const Box3 box = box_of(ends[k], ends[k + 1]);
      for (std::size_t a = 0; a < 3; ++a) {
        n.lo[a][k] = size > 0 ? rounded_down(in_frame(box.lo, static_cast<int>(a))) : 0;
        n.hi[a][k] = size > 0 ? -rounded_down(-in_frame(box.hi, static_cast<int>(a))) : 0;
      }
      const bool is_leaf = size <= leaf_size;
      n.child[k] = static_cast<std::uint32_t>(is_leaf ? ends[k] : 4 * node + 1 + k);
      n.count[k] = !is_leaf ? 0 : size > 0 ? static_cast<std::uint8_t>(size) : BoxHierarchy::empty_child;
      if (!is_leaf) fill(4 * node + 1 + k, ends[k], ends[k + 1], box);
    });
  }

  std::span<const Vec3> positions_;
  Tree& tree_;
};

NearestSample::NearestSample(std::span<const Vec3> positions, std::span<const std::int8_t> labels)
    : positions_(positions), sides_(2) {
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const std::size_t side = place_of(labels[i]);
    if (side >= sides_.size()) sides_.resize(side + 1);
    sides_[side].boxes.ids.push_back(i);
  }
  for (Tree& tree : sides_) Builder(positions_, tree).build();
}

NearestSample::Best NearestSample::search(const Tree& tree, Vec3 p, const Best& best,
                                          double squared_enough) const {
  const FramePoint from(tree.boxes, p);
  const auto at_leaf = [&](std::uint32_t first, std::uint32_t count, Best& found) {
    const std::uint32_t end = first + count;
    float limit = from.limit(found.squared_distance);
    for (std::uint32_t i = first; i < end; i += lane_count) {
      const Lanes bounds = from.bounds({&tree.rough[0][i], &tree.rough[1][i], &tree.rough[2][i]});
      for (std::uint32_t k = 0; k < std::min<std::uint32_t>(lane_count, end - i); ++k) {
        if (!(bounds[k] <= limit)) continue;
        const std::uint32_t sample = tree.boxes.ids[i + k];
        found.offer(squared_length(positions_[sample] - p), sample);
        limit = from.limit(found.squared_distance);
      }
    }
  };
  return search_boxes(
      tree.boxes, from, best, squared_enough, [](std::uint32_t) { return Lanes{}; }, at_leaf);
}

SampleId NearestSample::nearest(Vec3 p, double radius) const {
  Best best{radius * radius, SampleId::none};
  for (const Tree& tree : sides_) best = search(tree, p, best);
  return SampleId(best.sample);
}

SampleId NearestSample::nearest_of(Vec3 p, int label, double radius) const {
  if (!has(label)) return {};
  return SampleId(search(sides_[place_of(label)], p, {radius * radius, SampleId::none}).sample);
}

bool NearestSample::has_near(Vec3 p, int label, double radius) const {
  if (!has(label)) return false;
  const double r2 = radius * radius;
  return search(sides_[place_of(label)], p, {r2, SampleId::none}, r2).sample != SampleId::none;
}

std::size_t NearestSample::memory_bytes() const {
  std::size_t bytes = 0;
  for (const Tree& tree : sides_) {
    bytes += tree.boxes.memory_bytes();
    for (const std::vector<float>& values : tree.rough) bytes += values.capacity() * sizeof(float);
  }
  return bytes;
}

} // namespace isoscope
