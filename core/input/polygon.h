// Cuts flat or nearly flat polygons of space into triangles, and tells how flat they are.
#pragma once

#include "base/geometry.h"
#include "base/run_control.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Up to so many corners a polygon is cut by ear clipping, beyond by a Delaunay triangulation.
constexpr std::size_t most_clipped_corners = 128;

/// Appends triangles that fill the polygon's outline and keep its orientation: n - 2 of them where it does
/// not cross itself. `corners` index into `points`; a point may occur twice, as where a bridge leads to a
/// hole. Small polygons are cut by clip_ears; larger ones, in O(n log n) time, by a constrained Delaunay
/// triangulation in the coordinate plane that they face most. Large ones that cross themselves or have no
/// area are cut somehow, and false is returned. Ends early, with part of the triangles, when the control says
/// so.
bool triangulate_polygon(std::span<const Vec3> points, std::span<const std::uint32_t> corners,
                         const RunControl& control, std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The largest distance of a corner from the plane through the corners' centre across the area vector; 0 for
/// triangles and for polygons without area.
double flatness_deviation(std::span<const Vec3> points, std::span<const std::uint32_t> corners);

} // namespace isoscope
