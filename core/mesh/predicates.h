// Exact signs for plain points: the only place that decides on which side a point lies.
#pragma once

#include "base/geometry.h"

#include <array>

namespace isoscope {

/// Sign of det(b − a, c − a, d − a): +1 when d is on the positive side of abc. Exact.
int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// Sign of the in-sphere test: +1 when e is strictly inside the ball through the positively oriented abcd.
/// Exact.
int side_of_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e);
/// Like orientation, but never 0 for a proper triangle: d is shifted infinitesimally along a fixed generic
/// direction. Exact, hence antisymmetric in a, b, c: the two tetrahedra on a facet give opposite answers. 0
/// only where a, b, c are collinear.
int orientation_perturbed(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// Whether the positively oriented tetrahedron t holds x in the sense of orientation_perturbed against its
/// four facets. The tetrahedra of a triangulation hold every point of its interior exactly once.
bool holds_perturbed(const std::array<Vec3, 4>& t, Vec3 x);

} // namespace isoscope
