// Where points and triangles lie with respect to closed surfaces, by exact predicates.
#pragma once

#include "tolerance/closest_point.h"

#include <functional>
#include <optional>
#include <vector>

namespace isoscope {

/// Whether a triangle, which may have no area, and one with an area have a point in common.
bool triangles_meet(const Triangle3& facet, const Triangle3& wall);

/// The triangles that a way from p to the outside of the index's box crosses, of those that `counts` takes:
/// each in its inside, exactly. Nothing where p lies on one of them.
std::optional<std::vector<TriangleId>> crossed_on_the_way_out(
    Vec3 p, const ClosestPointIndex& index,
    const std::function<bool(TriangleId)>& counts = [](TriangleId) { return true; });

} // namespace isoscope
