// What is to be outside where parts are to be one, as Ω joins them.
#pragma once

#include "base/run_control.h"
#include "criteria/nearest_sample.h"
#include "criteria/topology.h"
#include "tolerance/tolerance_volume.h"

#include <optional>
#include <vector>

namespace isoscope {

/// The points within some reach of the region outside of Ω', as its samples tell. Their boundary lies in Ω;
/// gaps that Ω' closes are inside of it, wherever the input has its own sides. Where walls meet at a sharp
/// angle the outside of Ω' ends in a wedge as thin as can be; around that they are blunt, so that their
/// boundary is one whose topology can be counted, and made.
class OuterOffset {
 public:
  /// Both must outlive it. The samples are those of S; the sides of the input are known. `reach` is below δ'
  /// and above what lies between samples.
  OuterOffset(const ToleranceVolume& volume, const NearestSample& samples, double reach);
  /// Some two thirds of δ', for samples of density sigma.
  static double usual_reach(const ToleranceVolume& volume, double sigma);

  /// How deep p is inside; negative outside.
  double depth(Vec3 p) const;

 private:
  const ToleranceVolume& volume_;
  const NearestSample& samples_;
  double reach_;
  struct Ball {
    Vec3 center;
    double radius;
  };
  std::vector<Ball> held_; ///< in gaps of one part that are held open; they touch its walls
};

/// What the boundary of an offset of the outside is, in place of what is expected of Z: of the usual one, or,
/// where it has handles that counts do not agree on, of one where they do. What no counts agree on is not
/// required. Nothing where it can not be counted, or once cancelled.
std::optional<ExpectedTopology> outer_offset_topology(const ToleranceVolume& volume,
                                                      const NearestSample& samples, double sigma,
                                                      const RunControl& control);

} // namespace isoscope
