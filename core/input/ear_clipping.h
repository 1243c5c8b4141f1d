// Cuts small polygons into triangles, the shortest cut first.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Appends n - 2 triangles that keep the polygon's orientation, by ear clipping in the plane of its area
/// vector, the shortest cut first. `corners` index into `points`; a point may occur twice, as where a bridge
/// leads to a hole. Polygons that cross themselves or have no area are cut somehow. Takes O(n²) time.
void clip_ears(std::span<const Vec3> points, std::span<const std::uint32_t> corners,
               std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace isoscope
