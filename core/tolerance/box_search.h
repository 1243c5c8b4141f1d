// Searches of a box hierarchy, for whatever its boxes hold. Inlined: they are the innermost loops of
// everything.
#pragma once

#include "tolerance/box_hierarchy.h"
#include "tolerance/field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace isoscope {

/// Nodes that wait on a search's stack: three a level, and levels are bounded by the builder.
inline constexpr std::size_t box_stack_size = 256;
/// Longer lists of neighbours would be slower than the hierarchy.
inline constexpr std::size_t most_neighbors = 128;

/// Four floats that the compiler keeps in one register: branches for each of them cost more than the sums.
using Lanes = float __attribute__((vector_size(16)));

inline Lanes lanes(const float* values) {
  Lanes loaded;
  std::memcpy(&loaded, values, sizeof loaded);
  return loaded;
}

/// Children that wait in a search, the one with the smallest bound on top of those pushed together. Entries
/// are single words: bounds are not negative, so that their bits have their order.
class WaitingChildren {
 public:
  bool empty() const { return top_ == 0; }
  /// Where the children of another node begin.
  void begin_node() { first_ = top_; }
  /// `bound`: of the squared distance, in the normalised frame.
  void push(float bound, std::uint32_t child, std::uint8_t count) {
    const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(bound)} << 32 | child;
    std::size_t at = top_++;
    for (; at > first_ && keys_[at - 1] < key; --at) keys_[at] = keys_[at - 1], counts_[at] = counts_[at - 1];
    keys_[at] = key;
    counts_[at] = count;
  }
  void pop() { --top_; }
  float bound() const { return std::bit_cast<float>(static_cast<std::uint32_t>(keys_[top_ - 1] >> 32)); }
  std::uint32_t child() const { return static_cast<std::uint32_t>(keys_[top_ - 1]); }
  std::uint32_t count() const { return counts_[top_ - 1]; }

 private:
  std::uint64_t keys_[box_stack_size];
  std::uint32_t counts_[box_stack_size];
  std::size_t top_ = 0, first_ = 0;
};

/// A point in a hierarchy's frame, as lower bounds of distances to boxes are computed from: in float, with
/// slack for every rounding, so that no item is missed.
class FramePoint {
 public:
  FramePoint(const BoxHierarchy& boxes, Vec3 p) : to_frame_(boxes.inverse_scale * boxes.inverse_scale) {
    float q[3], reach = 1;
    for (int a = 0; a < 3; ++a) {
      const double x = std::clamp((p[a] - boxes.origin[a]) * boxes.inverse_scale, -1e15, 1e15);
      q[a] = static_cast<float>(x);
      reach = std::max(reach, std::abs(q[a]));
    }
    const float slack = float_slack * reach;
    for (int a = 0; a < 3; ++a) from_below_[a] = q[a] + slack, from_above_[a] = q[a] - slack;
  }
  /// What the bounds of boxes at that squared distance do not exceed.
  float limit(double squared) const {
    return static_cast<float>(std::min(squared * to_frame_, 1e37)) * (1 + 2 * float_slack);
  }
  /// Of the squared distances to a node's children, each more by what `least` says.
  Lanes bounds(const BoxHierarchy::Node& n, Lanes least) const {
    return bounds({n.lo[0], n.lo[1], n.lo[2]}, {n.hi[0], n.hi[1], n.hi[2]}, least);
  }
  /// The same of four points of the frame by axis, rounded to the nearest float.
  Lanes bounds(const std::array<const float*, 3>& points) const { return bounds(points, points, Lanes{}); }

 private:
  Lanes bounds(const std::array<const float*, 3>& lo, const std::array<const float*, 3>& hi,
               Lanes least) const {
    for (unsigned a = 0; a < 3; ++a) {
      const Lanes below = lanes(lo[a]) - from_below_[a], above = from_above_[a] - lanes(hi[a]);
      Lanes d = below > 0 ? below : Lanes{};
      d = above > d ? above : d;
      least += d * d;
    }
    return least;
  }
  /// Relative rounding of a float operation, with room for the few that follow each other.
  static constexpr float float_slack = 4 * std::numeric_limits<float>::epsilon();
  double to_frame_;
  float from_below_[3], from_above_[3];
};

/// Improves `best`, which has a squared_distance, by the items whose box may hold something nearer to p or as
/// near, nearest boxes first, until nothing does or it is below `squared_enough`. `least(node)`: what is to
/// be added to the squared distances of its children's boxes, in the frame. `at_leaf(first, count, best)`
/// looks at the slots of a leaf.
template <class Best, class Least, class AtLeaf>
Best search_boxes(const BoxHierarchy& boxes, const FramePoint& from, Best best, double squared_enough,
                  const Least& least, const AtLeaf& at_leaf) {
  // Distances to items are computed in double.
  float limit = from.limit(best.squared_distance);

  WaitingChildren waiting;
  waiting.push(0, 0, 0);
  while (!waiting.empty()) {
    const float next_bound = waiting.bound();
    const std::uint32_t child = waiting.child(), count = waiting.count();
    waiting.pop();
    if (next_bound > limit) continue;
    if (count > 0) {
      at_leaf(child, count, best);
      if (best.squared_distance < squared_enough) return best;
      limit = from.limit(best.squared_distance);
      continue;
    }
    const BoxHierarchy::Node& n = boxes.nodes[child];
    const Lanes bound = from.bounds(n, least(child));
    waiting.begin_node();
    for (unsigned k = 0; k < BoxHierarchy::width; ++k)
      if (bound[k] <= limit && n.count[k] != BoxHierarchy::empty_child)
        waiting.push(bound[k], n.child[k], n.count[k]);
  }
  return best;
}

template <class Best, class Least, class AtLeaf>
Best search_boxes(const BoxHierarchy& boxes, Vec3 p, const Best& best, double squared_enough,
                  const Least& least, const AtLeaf& at_leaf) {
  return search_boxes(boxes, FramePoint(boxes, p), best, squared_enough, least, at_leaf);
}

/// Calls at_leaf(first, count) for each leaf whose box may hold something within a reach of p; ends when that
/// returns false. `least` as for search_boxes.
template <class Least, class AtLeaf>
void visit_within(const BoxHierarchy& boxes, Vec3 p, double squared_reach, const Least& least,
                  const AtLeaf& at_leaf) {
  const FramePoint from(boxes, p);
  const float limit = from.limit(squared_reach);
  std::uint32_t stack[box_stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t node = stack[--top];
    const BoxHierarchy::Node& n = boxes.nodes[node];
    const Lanes bound = from.bounds(n, least(node));
    for (unsigned k = 0; k < BoxHierarchy::width; ++k) {
      if (!(bound[k] <= limit) || n.count[k] == BoxHierarchy::empty_child) continue;
      if (n.count[k] == 0)
        stack[top++] = n.child[k];
      else if (!at_leaf(n.child[k], n.count[k]))
        return;
    }
  }
}

/// Squared distances from a point to the boxes of a node's children, in the input's unit; too small rather
/// than too large by the margin that goes with it.
struct ChildDistances {
  double squared[BoxHierarchy::width] = {};

  ChildDistances(const BoxHierarchy& boxes, const BoxHierarchy::Node& n, Vec3 center) {
    const double scale = 1 / boxes.inverse_scale;
    for (int a = 0; a < 3; ++a) {
      const double x = (center[a] - boxes.origin[a]) * boxes.inverse_scale;
      const auto axis = static_cast<std::size_t>(a);
      for (unsigned k = 0; k < BoxHierarchy::width; ++k) {
        const double below = static_cast<double>(n.lo[axis][k]) - x,
                     above = x - static_cast<double>(n.hi[axis][k]);
        const double d = std::max(0.0, std::max(below, above)) * scale;
        squared[k] += d * d;
      }
    }
  }
  /// What their roots may be too large by.
  static double margin(const BoxHierarchy& boxes, Vec3 center) {
    return 1e-12 / boxes.inverse_scale * std::max(1.0, length(center - boxes.origin) * boxes.inverse_scale);
  }
};

/// Calls at_leaf(first, count) for each leaf for which meets(node, child, its squared distance from `center`)
/// holds, as it must for all above it; ends when that returns false.
template <class Meets, class AtLeaf>
void visit_boxes(const BoxHierarchy& boxes, Vec3 center, const Meets& meets, const AtLeaf& at_leaf) {
  std::uint32_t stack[box_stack_size];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t node = stack[--top];
    const BoxHierarchy::Node& n = boxes.nodes[node];
    const ChildDistances distances(boxes, n, center);
    for (unsigned k = 0; k < BoxHierarchy::width; ++k) {
      if (n.count[k] == BoxHierarchy::empty_child || !meets(node, k, distances.squared[k])) continue;
      if (n.count[k] == 0) {
        stack[top++] = n.child[k];
        continue;
      }
      if (!at_leaf(n.child[k], n.count[k])) return;
    }
  }
}

/// Puts a list of neighbours in order.
inline void sort_neighbors(std::vector<TriangleNeighborhood::Entry>& entries) {
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.slot < b.slot;
  });
}

} // namespace isoscope
