// The σ-dense sample S of ∂Ω with its labels (§2.2).
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// Samples of ∂Ω as parallel arrays, in a fixed order that does not depend on the number of threads,
/// spatially coherent.
struct BoundarySamples {
  std::vector<Vec3> positions;     ///< on d = δ' up to rounding, snapped to the grid of snap_unit
  std::vector<std::int8_t> labels; ///< of their sides
  std::vector<std::uint16_t>
      components;             ///< index into ToleranceVolume::boundary_components(), 0xffff unknown
  std::vector<Vec3> over_rim; ///< the boundary samples B: over the open rim, on no side (§4.1)
  double sigma = 0;           ///< what was asked for
  double covering_radius = 0; ///< proven: every point of ∂Ω outside undecided cells has a sample this near
  std::size_t undecided_cells =
      0;                ///< cells at the depth limit that hold no sample: crevices thinner than they are
  double snap_unit = 0; ///< coordinates are multiples of this power of two

  std::size_t size() const { return positions.size(); }
};

/// How near to each point of ∂Ω a sample is asked for.
struct SampleDensity {
  double sigma;
  /// Where ∂Ω is a plane farther around than 2δ, of closed input with one region on each side; 0: σ.
  double flat_sigma = 0;

  SampleDensity(double sigma_, double flat_sigma_ = 0) : sigma(sigma_), flat_sigma(flat_sigma_) {}
};

/// Samples ∂Ω with covering radius <= sigma, in planes flat_sigma. Streams blocks; at most 200 bytes a sample
/// at the peak.
Result<BoundarySamples> sample_boundary(ToleranceVolume& volume, SampleDensity density,
                                        const RunControl& control);

} // namespace isoscope
