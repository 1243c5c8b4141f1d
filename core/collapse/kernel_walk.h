// Points drawn inside a kernel: a hit-and-run walk.
#pragma once

#include "criteria/kernel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// `n` points of the intersection of the half-spaces: from `start`, which must be one of them, each step goes
/// to a uniform point of a line with uniform direction. In the limit uniform in the intersection, which must
/// be bounded; consecutive points depend on each other. The same points for the same arguments.
std::vector<Vec3> walk_kernel(std::span<const HalfSpace> half_spaces, Vec3 start, int n, std::uint64_t seed);

} // namespace isoscope
