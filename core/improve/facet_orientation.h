// Condition 3 carried to facets of Z: the plane of a facet classifies the samples nearest to its shrunk copy
// (§2.3, §2.4).
#pragma once

#include "base/geometry.h"
#include "criteria/nearest_sample.h"
#include "improve/facet_complex.h"
#include "tolerance/closest_point.h"

namespace isoscope {

/// What facets are tested against. The test is about the points of ∂Ω nearest to the shrunk copy. Samples
/// stand for them, up to σ beside and a little inside of ∂Ω; where a sample fails, the way from it to the
/// nearest point of ∂Ω is gone, and that point decides.
struct OrientationTester {
  const NearestSample* samples = nullptr;
  double shrink = 0.7; ///< size of the copy about the centroid
  double radius = 0;   ///< a sample farther than this from a shrunk corner says nothing about the place
  const ToleranceField* field = nullptr;
  double delta = 0; ///< δ

  /// Failed tests among the six (three corners, both sides), as points of ∂Ω: the positive one must lie on
  /// the positive side of the facet, the negative one on the negative side.
  /// `labels`: what the facet lies between, the larger one on its positive side.
  std::vector<SideSample> failures(const Triangle3& facet, LabelPair labels = {+1, -1}) const;

 private:
  /// The point with φ = δ on the ray from the input through x; x near ∂Ω.
  Vec3 on_boundary(Vec3 x) const;
  /// The point of ∂Ω to which sliding from the sample towards x leads.
  Vec3 nearest_on_boundary(Vec3 x, Vec3 sample) const;
};

} // namespace isoscope
