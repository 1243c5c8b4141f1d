// The sample nearest to a point, over all of S or one side of it.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Bounding box trees over each side of S; immutable, thread-safe. Ties go to the smallest id.
class NearestSample {
 public:
  NearestSample(std::span<const Vec3> positions, std::span<const std::int8_t> labels);
  /// The nearest sample at most `radius` from p; invalid when there is none.
  SampleId nearest(Vec3 p, double radius = Box3::inf) const;
  /// The same among the samples of one side, told by its label.
  SampleId nearest_of(Vec3 p, int label, double radius = Box3::inf) const;
  bool has(int label) const {
    return place_of(label) < sides_.size() && !sides_[place_of(label)].order.empty();
  }
  std::span<const Vec3> positions() const { return positions_; }
  std::size_t memory_bytes() const;

 private:
  /// A balanced tree in heap order: node k halves its range of `order` between nodes 2k + 1 and 2k + 2.
  struct Tree {
    std::vector<std::uint32_t> order;
    std::vector<Box3> boxes;
  };
  struct Best;
  struct Range;
  void build(Tree& tree, const Range& range);
  void search(const Tree& tree, const Range& range, Vec3 p, Best& best) const;

  std::span<const Vec3> positions_;
  std::vector<Tree> sides_; ///< by place_of their labels; a search over all of S asks each
};

} // namespace isoscope
