// Ψ: targets of a collapse that are known to violate the tolerance, from one that did (§2.4.1, §2.4.3,
// Figures 9 and 12).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "criteria/kernel.h"
#include "mesh/edge_star.h"

#include <optional>
#include <vector>

namespace isoscope {

/// A convex set of targets, none of which can be taken: the intersection of the half-spaces and, if there is
/// one, the open ball. Without either it holds nothing.
struct InvalidRegion {
  struct Ball {
    Vec3 center;
    double radius = 0;
  };
  std::vector<HalfSpace> half_spaces;
  std::optional<Ball> ball;
  TetId tet;       ///< sampled mode: the tetrahedron that would hold the sample
  SampleId sample; ///< sampled mode: the sample that would be misclassified

  bool empty() const { return half_spaces.empty() && !ball; }
  bool contains(Vec3 x) const;
  /// Whether the whole box is inside; exact up to rounding.
  bool contains_box(const Box3& box) const;
};

/// Sampled mode: the targets T for which the tetrahedron of T and the facet ABC that `tet` keeps holds the
/// sample E and gives it the wrong class.
///
/// T with E = αA + βB + γC + τT, all weights >= 0, is the cone E + pos(E − A, E − B, E − C): three
/// half-spaces, the lines a and b of the figures. Within it the class of E is a fourth, the line m: with the
/// coordinates x = α/τ, y = β/τ, z = γ/τ of T in that cone f(E) has the sign of x f(A) + y f(B) + z f(C) +
/// f(T), which is affine in T whatever the labels of A, B and C are and however many of them are vertices of
/// Z.
///  - Interpolated Z: E is misclassified where label·f(E) < margin (α of condition 1), f(T) being
///    `target_value`. m is where the linear function with the values of A, B and C that is 0 at E
///    has the value f(T): parallel to its zero set n, which passes through E and the fixed zeros on ABC, or
///    is parallel to ABC where the three have one label.
///  - Embedded Z: the side of `tet` decides, and the cone itself is Ψ where that side is not E's; it holds
///    nothing elsewhere. The union over the tetrahedra that share the wrong side is the region of Figure 12.
///
/// Holds nothing where E lies in the plane of ABC.
InvalidRegion invalid_region(const EdgeStar& star, const EdgeStar::StarTet& tet,
                             const EdgeStar::StarSample& sample, double target_value, double margin);

/// Certified mode, where there are no samples: a point w = τT + … of a facet at the target T has d(w) > δ. As
/// d changes by no more than its argument moves and w by τ times what T moves, the same barycentric point
/// stays outside Ω for all targets nearer to T than (d(w) − δ)/τ. `weight` is τ > 0, `excess` d(w) − δ >= 0.
InvalidRegion invalid_region(Vec3 target, double weight, double excess);

/// The part of Ψ inside a kernel for display, the ball as a polyhedron of tangent planes. A face's source:
/// the half-spaces of the kernel come first, then those of Ψ, then the planes of the ball. Without vertices
/// where they have no room in common.
KernelPolyhedron invalid_polyhedron(const InvalidRegion& region, const Kernel& kernel);

} // namespace isoscope
