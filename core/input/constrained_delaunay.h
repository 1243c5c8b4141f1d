// Triangulates one large polygon.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Appends the triangles of the constrained Delaunay triangulation inside the polygon, in the coordinate
/// plane across the largest part of `area`, its area vector. False, with nothing appended, when edges cross,
/// two corners of different height lie on each other, the area is zero, or the control says to end.
bool triangulate_delaunay(std::span<const Vec3> points, std::span<const std::uint32_t> corners, Vec3 area,
                          const RunControl& control, std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace isoscope
