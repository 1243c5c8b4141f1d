// The sample nearest to a point, over all of S or one side of it.
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/labels.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/box_hierarchy.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
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
  /// Whether there is a sample of that side at most `radius` from p.
  bool has_near(Vec3 p, int label, double radius) const;
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
  Best search(const Tree& tree, Vec3 p, const Best& best, double squared_enough = 0) const;

  std::span<const Vec3> positions_;
  std::vector<Tree> sides_; ///< by place_of their labels; a search over all of S asks each
};

/// S with what finds the nearest of its samples, for all who ask.
struct SearchedSamples {
  SearchedSamples(std::shared_ptr<const BoundarySamples> of)
      : samples(std::move(of)),
        nearest(std::make_shared<const NearestSample>(samples->positions, samples->labels)) {}

  std::shared_ptr<const BoundarySamples> samples;
  std::shared_ptr<const NearestSample> nearest; ///< as long as the samples are there
};

} // namespace isoscope
