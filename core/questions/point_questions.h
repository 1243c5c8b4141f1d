// What a person asks of a point that Ω is made of: its neighbours, and what stands for it in φ.
#pragma once

#include "base/geometry.h"
#include "run/pipeline.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

struct PointInspection {
  Vec3 position;
  std::vector<std::uint32_t> neighbors; ///< the k nearest points, itself among them, ascending by distance
  Vec3 mean;                            ///< b, of the neighbours
  double weight = 0;                    ///< w, their mean squared distance from b
  bool kept = true;                     ///< a site stands for it
  DroppedPoints::Why dropped = DroppedPoints::Why::outliers; ///< where none does
  double phi = 0;                                            ///< of the field, at the point

  /// Of the ball that the point gives Ω: 0 where there is none.
  double ball_radius(double delta) const;
};

/// Looks at every point. Nothing where the scene's field is not one of points, or has not so many.
std::optional<PointInspection> inspect_point(const Scene& scene, std::uint32_t point);

} // namespace isoscope
