// The error that orders collapses and places their targets: squared distances to the planes of Z's facets
// (§2.4).
#pragma once

#include "base/geometry.h"
#include "criteria/kernel.h"
#include "mesh/edge_star.h"

#include <array>
#include <optional>
#include <span>

namespace isoscope {

/// The sum of the squared distances to the planes of the star's cost facets and to the lines of its border
/// edges, each with weight 1; facets without a plane are left out.
class CollapseCost {
 public:
  explicit CollapseCost(const EdgeStar& star);
  /// Squared length, never negative.
  double operator()(Vec3 x) const;
  /// The error is convex: at y it is at least (*this)(x) + gradient(x)·(y − x).
  Vec3 gradient(Vec3 x) const;
  /// Where the error is least; drawn to the middle of the edge in directions in which it does not change.
  Vec3 optimum() const;
  /// The same over the half-spaces; nothing when they have no common point.
  std::optional<Vec3> minimum(std::span<const HalfSpace> half_spaces) const;

 private:
  Vec3 forward(Vec3 r) const;  ///< L⁻¹ r
  Vec3 backward(Vec3 r) const; ///< L⁻ᵀ r

  // q(u) = uᵀAu + 2 b·u + c with u = (x − middle) / size.
  Vec3 middle_;
  double size_ = 1;
  std::array<double, 6> a_{}; ///< xx, xy, xz, yy, yz, zz
  Vec3 b_;
  double c_ = 0;
  std::array<double, 6> l_{}; ///< Cholesky factor of A + regularisation: xx, yx, yy, zx, zy, zz
};

} // namespace isoscope
