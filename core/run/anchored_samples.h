// Which samples stay on their side of any Z in Ω, because what lies beyond δ at them does.
#pragma once

#include "base/run_control.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/deep_cells.h"
#include "tolerance/tolerance_volume.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// Samples lie at δ', where Z inside Ω may still pass. A part of {d > δ} beside a sample has a witness, or is
/// the one around open surfaces, whose sides their border parts. Where there is none, in walls and gaps
/// between 2δ' and 2δ wide, or where that part is cut off from the one around an open surface, Z could pass
/// by. Thread-safe; the volume, with its octree where it has open surfaces, and the samples must outlive it.
class AnchoredSamples {
 public:
  /// Of no use once the control is cancelled.
  AnchoredSamples(const ToleranceVolume& volume, const BoundarySamples& samples, const RunControl& control);

  /// Whether a part of {d > δ} that holds the side of the sample is seen from it. It may be that there is one
  /// all the same.
  bool is_anchored(SampleId sample) const;

 private:
  const ToleranceVolume& volume_;
  const BoundarySamples& samples_;
  std::optional<DeepCells> cells_;              ///< of volumes with open surfaces
  DeepCells::CellIndex around_ = Regions::none; ///< the group of cells around all
  /// By sample, 0 where nobody has asked yet.
  mutable std::vector<std::atomic<std::int8_t>> known_;

  bool find(Vec3 p) const;
  bool is_around(Vec3 p) const;
};

} // namespace isoscope
