// The sample nearest to a point, over all of S or one side of it.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"
#include "tolerance/box_hierarchy.h"

#include <array>
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
    return place_of(label) < sides_.size() && !sides_[place_of(label)].boxes.ids.empty();
  }
  std::span<const Vec3> positions() const { return positions_; }
  std::size_t memory_bytes() const;

 private:
  /// A balanced tree in heap order: node k quarters its range of samples between nodes 4k + 1 to 4k + 4.
  struct Tree {
    BoxHierarchy boxes;
    std::array<std::vector<float>, 3> rough; ///< by axis: places of the samples in the frame, by slot
  };
  struct Best;
  class Builder;
  Best search(const Tree& tree, Vec3 p, const Best& best) const;

  std::span<const Vec3> positions_;
  std::vector<Tree> sides_; ///< by place_of their labels; a search over all of S asks each
};

} // namespace isoscope
