// Samples of ∂Ω along the wall over the rim of open surfaces, where Z is to reach the rim (§4.1).
#pragma once

#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <vector>

namespace isoscope {

struct WallSample {
  Vec3 point; ///< in Ω', at most 0.7 δ' from the input, not snapped
  std::int8_t label = 0;
  bool in_gap = false; ///< another part of the input is nearer than the sheet that it stands on
};

/// Pairs of points, one on each side of the sheet, a little before each piece of the open rim: Z passes
/// between them, so that its border comes near to all of the rim. They lie within Ω', so that there is room
/// up to δ. None where both are not on different sides. In the order of the rim; empty for volumes without
/// open surfaces.
std::vector<WallSample> wall_samples(const ToleranceVolume& volume);

} // namespace isoscope
