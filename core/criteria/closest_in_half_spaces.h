// The point of an intersection of half-spaces nearest to a given point.
#pragma once

#include "base/geometry.h"
#include "criteria/kernel.h"

#include <optional>
#include <span>

namespace isoscope {

/// Nearest to p; nothing when the half-spaces have no common point. Relative to lengths of about 1:
/// half-spaces are kept up to 1e-12.
std::optional<Vec3> closest_in_half_spaces(std::span<const HalfSpace> half_spaces, Vec3 p);

} // namespace isoscope
