// Proof that a triangle lies inside Ω, by branch and bound on the 1-Lipschitz distance (algorithm notes §4).
#pragma once

#include "tolerance/closest_point.h"

#include <cstddef>

namespace isoscope {

/// The outcome for one triangle and its witness.
struct FacetVerdict {
  enum class Kind { inside, outside, undecided };
  Kind kind = Kind::undecided;
  Vec3 witness; ///< outside: a point of the triangle with d > reject; undecided: the last one looked at
  ClosestPoint closest;    ///< of the witness
  double max_distance = 0; ///< inside: proven upper bound of d over the triangle
  std::size_t pieces = 0;  ///< pieces looked at
};

/// Accepts when d <= accept is proven everywhere (rounded outward), rejects at the first point found with d >
/// reject (reject <= accept), undecided when `budget` pieces did not suffice. `guess`, an input triangle
/// close to the facet, makes it faster and max_distance looser. Allocates nothing.
FacetVerdict certify_facet(const ClosestPointIndex& index, const Triangle3& facet, double accept,
                           double reject, std::size_t budget = 20000, TriangleId guess = {});

} // namespace isoscope
