// An order of samples in which every prefix is spread evenly over the surface.
#pragma once

#include "base/geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Sample ids ordered coarse to fine: first one of each large cell of an octree over the positions, then of
/// each smaller one. The two labels are spread separately. Depends on the positions and labels alone.
std::vector<std::uint32_t> thinning_order(std::span<const Vec3> positions,
                                          std::span<const std::int8_t> labels);

} // namespace isoscope
