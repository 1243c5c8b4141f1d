// Surfaces of unions of unit cubes, whose topology is known by counting.
#pragma once

#include "input/triangle_soup.h"

#include <array>
#include <functional>

namespace isoscope::test {

/// The boundary of the cubes (x, y, z), 0 <= x < size[0] and so on, that `solid` names; two triangles a face,
/// oriented outwards, vertices shared, also those of cubes that touch at an edge or a vertex only.
TriangleSoup voxel_surface(std::array<int, 3> size, const std::function<bool(int, int, int)>& solid);

} // namespace isoscope::test
