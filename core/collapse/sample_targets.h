// Samples of S near the star of an edge: where a ∂Γ collapse may put its target (§2.4.1, Figure 8).
#pragma once

#include "mesh/edge_star.h"
#include "tolerance/boundary_sampler.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace isoscope {

/// How many samples are judged as targets of one collapse, those of least error.
constexpr int most_sample_targets = 24;

/// The samples of each label by cell of a grid; refers to them.
class SampleTargets {
 public:
  explicit SampleTargets(const BoundarySamples& samples);
  /// Positions of the samples with the label of the edge's ends in the star's box, in the order of their ids.
  std::vector<Vec3> near(const EdgeStar& star) const;

 private:
  using Cell = std::array<std::int32_t, 4>; ///< a label and three places
  Cell cell_of(int label, Vec3 p) const;

  const BoundarySamples& samples_;
  double size_; ///< of a cell
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

} // namespace isoscope
