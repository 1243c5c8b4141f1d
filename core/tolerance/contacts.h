// Where triangles meet that are no neighbours: closed parts that touch or cross.
#pragma once

#include "base/run_control.h"
#include "tolerance/closest_point.h"
#include "tolerance/input_sides.h"

#include <array>
#include <vector>

namespace isoscope {

/// A segment or, where both ends are the same, a point that triangles share.
using Contact = std::array<Vec3, 2>;

/// Edges of more than two triangles; vertices whose triangles are not joined across edges; what two triangles
/// without a common edge share elsewhere (constructed in double precision). Copies of a triangle count once.
/// In no particular order that means anything, but always in the same; cut short when cancelled.
std::vector<Contact> find_contacts(const ClosestPointIndex& index, const RunControl& control);

/// Parts this near each other, in units of δ, touch as far as anyone can tell: no surface of few triangles
/// passes between them.
constexpr double touching_gap = 0.02;

/// Points of gaps outside of at most touching_gap δ between parts without a common vertex: along the edges of
/// both, about `spacing` apart.
std::vector<Contact> find_near_contacts(const ClosestPointIndex& index, const InputSides& sides, double delta,
                                        double spacing, const RunControl& control);

} // namespace isoscope
