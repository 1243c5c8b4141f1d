// The sample nearest to a point, over all of S or one side of it.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// kd-trees over S and over each side; immutable, thread-safe. Ties go to the smallest id.
class NearestSample {
 public:
  NearestSample(std::span<const Vec3> positions, std::span<const std::int8_t> labels);
  /// Invalid when there is no sample (of that side).
  SampleId nearest(Vec3 p) const;
  SampleId nearest(Vec3 p, int label) const;
  std::span<const Vec3> positions() const { return positions_; }
  std::size_t memory_bytes() const;

 private:
  struct Tree {
    std::vector<std::uint32_t> order;
    std::vector<std::uint8_t> axis;
  };
  void build(Tree& tree, std::size_t begin, std::size_t end);
  SampleId search(const Tree& tree, Vec3 p) const;
  std::span<const Vec3> positions_;
  Tree positive_, negative_; ///< a search over all of S asks both
};

} // namespace isoscope
