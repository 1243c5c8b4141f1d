// How many samples a density takes and how much memory they need, told before sampling from the octree alone.
#pragma once

#include "tolerance/tolerance_volume.h"

#include <cstdint>

namespace isoscope {

/// What sampling ∂Ω' will take. Areas come from the number of cells along the boundary: right to about a
/// tenth where the boundary is smooth.
struct SampleEstimate {
  double boundary_area = 0;      ///< of ∂Ω', both sides
  double bytes_before = 0;       ///< of the input, its index and the octree
  double bytes_by_sample = 0;    ///< what a run needs for each of them at its peak, T and journal included
  double samples_by_density = 0; ///< samples for each σ² of ∂Ω'

  double samples(double sigma) const { return samples_by_density * boundary_area / (sigma * sigma); }
  double bytes(double sigma) const { return bytes_before + bytes_by_sample * samples(sigma); }
  /// The smallest σ whose samples fit into so many bytes; infinite when none does.
  double smallest_sigma(double bytes) const;
};

SampleEstimate estimate_samples(const ToleranceVolume& volume);

} // namespace isoscope
