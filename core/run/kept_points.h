// Points that keep Z near, found by how near they are.
#pragma once

#include "tolerance/sample_grid.h"

#include <algorithm>
#include <vector>

namespace isoscope {

/// Grows by points; tells whether one of them is within a distance that is the same for all questions.
class KeptPoints {
 public:
  KeptPoints(Vec3 origin, double reach) : reach_(reach), grid_(origin, reach) {}

  void add(Vec3 p) {
    points_.push_back(p);
    grid_.add(p);
  }
  bool has_near(Vec3 p) const {
    std::vector<std::uint32_t> found;
    grid_.gather(Box3{p, p}.grown(reach_), found);
    return std::any_of(found.begin(), found.end(),
                       [&](std::uint32_t i) { return distance(points_[i], p) <= reach_; });
  }

 private:
  double reach_;
  std::vector<Vec3> points_;
  SampleGrid grid_; ///< of them
};

} // namespace isoscope
