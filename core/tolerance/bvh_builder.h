// Builds a box hierarchy: binned surface-area splits, four children a node.
#pragma once

#include "base/run_control.h"
#include "tolerance/box_hierarchy.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace isoscope {

/// One-shot: fills a hierarchy from the boxes of its items.
class BvhBuilder {
 public:
  /// Leaves hold at most so many items where asking one takes long, as of triangles, or not.
  static constexpr std::size_t small_leaf = 2, large_leaf = 4;
  /// `control`, where given, may stop it.
  BvhBuilder(BoxHierarchy& boxes, std::vector<Box3> items, const RunControl* control = nullptr,
             std::size_t leaf_size = small_leaf);
  /// False when it was stopped: the hierarchy is of no use then.
  bool build();

 private:
  struct Range {
    std::size_t begin, end;
    Box3 box;
    std::size_t size() const { return end - begin; }
  };
  const Box3& box(std::size_t i) const { return items_[order_[i]]; }
  Box3 box_of(std::size_t begin, std::size_t end) const;
  static constexpr unsigned bin_count = 16;
  /// What lies in each of equal slabs across an axis; those that are not used hold anything.
  struct Bins {
    unsigned used = 0; ///< a bit each
    std::array<Box3, bin_count> boxes;
    std::array<std::size_t, bin_count> counts{};
  };
  struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    unsigned bin = 0; ///< the last one of the left half
    Box3 left, right;
  };
  template <class BinOf>
  void fill_bins(const Range& range, const std::array<bool, 3>& axes, const BinOf& bin_of);
  static void find_split(const Bins& bins, int axis, Split& best);
  std::pair<Range, Range> split(const Range& range, unsigned depth);
  void fill_node(std::size_t node, const Range& range, unsigned depth);
  void set_box(std::size_t node, unsigned k, const Box3& box);

  BoxHierarchy& boxes_;
  const RunControl* control_;
  std::size_t leaf_size_;
  bool stopped_ = false;
  std::array<Bins, 3> bins_;
  std::vector<Box3> items_;
  std::vector<std::uint32_t> order_; ///< of the items, in the order of leaves
};

} // namespace isoscope
