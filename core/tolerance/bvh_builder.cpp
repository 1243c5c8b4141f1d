// Splits ranges of items until each leaf holds few.
#include "tolerance/bvh_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace isoscope {
namespace {

/// Fewer than there are but in a few inputs.
constexpr std::size_t usual_items_of_node = 3;
/// Ranges of so many items take long enough to ask before them whether to go on.
constexpr std::size_t worth_a_question = 1000;
/// Beyond this depth ranges are halved, which bounds the depth and with it the stacks of the searches.
constexpr unsigned max_surface_area_depth = 24;

double half_area(const Box3& b) {
  if (b.empty()) return 0;
  const Vec3 e = b.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

float round_down(double x) {
  const float f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float round_up(double x) {
  return -round_down(-x);
}

} // namespace

BvhBuilder::BvhBuilder(BoxHierarchy& boxes, std::vector<Box3> items, const RunControl* control,
                       std::size_t leaf_size)
    : boxes_(boxes), control_(control), leaf_size_(leaf_size), items_(std::move(items)),
      order_(items_.size()) {
  std::iota(order_.begin(), order_.end(), std::uint32_t{0});
}

Box3 BvhBuilder::box_of(std::size_t begin, std::size_t end) const {
  Box3 b;
  for (std::size_t i = begin; i < end; ++i) b.add(box(i));
  return b;
}

/// Fills the bins of all axes: one way through the items, which lie all over memory, serves them.
template <class BinOf>
void BvhBuilder::fill_bins(const Range& range, const std::array<bool, 3>& axes, const BinOf& bin_of) {
  for (Bins& b : bins_) b.used = 0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Box3& item = box(i);
    const Vec3 center = item.center();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!axes[axis]) continue;
      const unsigned b = bin_of(center, static_cast<int>(axis));
      Bins& bins = bins_[axis];
      if ((bins.used >> b & 1u) == 0) {
        bins.used |= 1u << b;
        bins.boxes[b] = item;
        bins.counts[b] = 1;
      } else {
        bins.boxes[b].add(item);
        ++bins.counts[b];
      }
    }
  }
}

/// Takes the cheapest split after one of an axis' bins, where it is cheaper than `best`.
void BvhBuilder::find_split(const Bins& bins, int axis, Split& best) {
  std::array<Box3, bin_count> after; ///< of what lies in later bins than each that is used
  std::array<double, bin_count> cost_after{};
  Box3 right;
  std::size_t right_count = 0;
  for (unsigned left = bins.used; left != 0;) {
    const unsigned b = static_cast<unsigned>(std::bit_width(left)) - 1;
    left &= ~(1u << b);
    after[b] = right;
    cost_after[b] = half_area(right) * static_cast<double>(right_count);
    right.add(bins.boxes[b]);
    right_count += bins.counts[b];
  }
  Box3 left;
  std::size_t left_count = 0;
  for (unsigned rest = bins.used; (rest & (rest - 1)) != 0; rest &= rest - 1) {
    const auto b = static_cast<unsigned>(std::countr_zero(rest));
    left.add(bins.boxes[b]);
    left_count += bins.counts[b];
    const double cost = half_area(left) * static_cast<double>(left_count) + cost_after[b];
    if (cost < best.cost) best = {cost, axis, b, left, after[b]};
  }
}

/// Orders the range and returns its halves.
std::pair<BvhBuilder::Range, BvhBuilder::Range> BvhBuilder::split(const Range& range, unsigned depth) {
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  Box3 centers;
  for (std::size_t i = range.begin; i < range.end; ++i) centers.add(box(i).center());
  const Vec3 extent = centers.extent();
  const auto bin_of = [&](Vec3 center, int axis) {
    const double u = (center[axis] - centers.lo[axis]) / extent[axis];
    return std::min(bin_count - 1, static_cast<unsigned>(u * bin_count));
  };
  Split best;
  if (depth < max_surface_area_depth) {
    const std::array<bool, 3> axes{extent.x > 0, extent.y > 0, extent.z > 0};
    fill_bins(range, axes, bin_of);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axes[axis]) find_split(bins_[axis], static_cast<int>(axis), best);
  }
  if (best.axis >= 0) {
    const auto middle = std::stable_partition(at(range.begin), at(range.end), [&](std::uint32_t id) {
      return bin_of(items_[id].center(), best.axis) <= best.bin;
    });
    const auto m = static_cast<std::size_t>(middle - order_.begin());
    return {{range.begin, m, best.left}, {m, range.end, best.right}};
  }
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
  const std::size_t middle = range.begin + range.size() / 2;
  std::nth_element(at(range.begin), at(middle), at(range.end), [&](std::uint32_t a, std::uint32_t b) {
    const double ca = items_[a].center()[axis], cb = items_[b].center()[axis];
    return ca != cb ? ca < cb : a < b;
  });
  return {{range.begin, middle, box_of(range.begin, middle)}, {middle, range.end, box_of(middle, range.end)}};
}

void BvhBuilder::set_box(std::size_t node, unsigned k, const Box3& box) {
  auto& n = boxes_.nodes[node];
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double lo = (box.lo[a] - boxes_.origin[a]) * boxes_.inverse_scale;
    const double hi = (box.hi[a] - boxes_.origin[a]) * boxes_.inverse_scale;
    n.lo[axis][k] = round_down(lo);
    n.hi[axis][k] = round_up(hi);
  }
}

void BvhBuilder::fill_node(std::size_t node, const Range& range, unsigned depth) {
  constexpr unsigned width = BoxHierarchy::width;
  if (control_ != nullptr && range.size() >= worth_a_question) stopped_ = stopped_ || control_->cancelled();
  if (stopped_) return;
  std::vector<Range> parts;
  if (range.size() > 0) parts.push_back(range);
  while (parts.size() < width) {
    std::size_t widest = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].size() > leaf_size_ &&
          (widest == parts.size() || half_area(parts[i].box) > half_area(parts[widest].box)))
        widest = i;
    if (widest == parts.size()) break;
    const auto [left, right] = split(parts[widest], depth);
    parts[widest] = left;
    parts.push_back(right);
  }
  for (unsigned k = 0; k < width; ++k) {
    if (k >= parts.size()) {
      boxes_.nodes[node].count[k] = BoxHierarchy::empty_child;
      for (std::size_t a = 0; a < 3; ++a)
        boxes_.nodes[node].lo[a][k] = boxes_.nodes[node].hi[a][k] = std::numeric_limits<float>::max();
      continue;
    }
    set_box(node, k, parts[k].box);
    if (parts[k].size() <= leaf_size_) {
      boxes_.nodes[node].child[k] = static_cast<std::uint32_t>(parts[k].begin);
      boxes_.nodes[node].count[k] = static_cast<std::uint8_t>(parts[k].size());
      continue;
    }
    const std::size_t child = boxes_.nodes.size();
    boxes_.nodes.emplace_back();
    boxes_.nodes[node].child[k] = static_cast<std::uint32_t>(child);
    boxes_.nodes[node].count[k] = 0;
    fill_node(child, parts[k], depth + 1);
  }
}

bool BvhBuilder::build() {
  if (items_.empty()) { // a root without children, at which every search ends
    boxes_.nodes.emplace_back();
    fill_node(0, {0, 0, {}}, 0);
    return true;
  }
  boxes_.bounds = box_of(0, items_.size());
  boxes_.origin = boxes_.bounds.center();
  const double scale = boxes_.bounds.longest_edge();
  boxes_.inverse_scale = scale > 0 && std::isfinite(1 / scale) ? 1 / scale : 1;
  boxes_.nodes.reserve(items_.size() / usual_items_of_node + 1); // what is not used takes no memory
  boxes_.nodes.assign(1, {});
  fill_node(0, {0, items_.size(), boxes_.bounds}, 0);
  if (stopped_) return false;
  boxes_.nodes.shrink_to_fit();
  boxes_.ids = std::move(order_);
  return true;
}

} // namespace isoscope
