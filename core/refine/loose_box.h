// The eight corners of the loose bounding box from which T starts (§2.2).
#pragma once

#include "mesh/complex.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/tolerance_volume.h"

#include <vector>

namespace isoscope {

/// Corners on a dyadic grid, a quarter of the longest edge outside of S. F is the outer label times the
/// distance to Ω in units of δ', rounded down to 2^k − 1 so that zeros of f stay representable, at least 1.
std::vector<Vertex> loose_box_corners(const ToleranceVolume& volume, const BoundarySamples& samples);

} // namespace isoscope
