// Condition 3: the linear function of a tetrahedron must classify the samples nearest to its shrunk copy
// (§2.3, Figure 4).
#pragma once

#include "base/ids.h"
#include "base/labels.h"
#include "criteria/nearest_sample.h"
#include "mesh/complex.h"

#include <array>

namespace isoscope {

/// How far a shrunk vertex looks for samples, in units of δ. The paper asks for the samples "locally": in a
/// wall thinner than 2δ, which has no boundary inside, the nearest sample of that side lies at some other
/// part of the surface and says nothing about this place.
constexpr double orientation_reach = 2.5;

/// One test of condition 3: a shrunk vertex, the nearest sample of one side, f there.
struct OrientationTest {
  Vec3 shrunk;     ///< vertex of the shrunk copy
  SampleId sample; ///< the nearest sample of the side `label`; invalid when none is within reach
  int label = +1;
  double f = 0; ///< the tetrahedron's function, as that side sees it, extrapolated to the sample
  bool asked() const { return sample.valid(); }
  bool good() const { return !asked() || f > 0; }
};

/// All eight tests (four vertices, both sides); a tetrahedron is misoriented when one is not good.
struct OrientationVerdict {
  std::array<OrientationTest, 8> tests;
  bool misoriented = false;
  int worst = -1; ///< index of the asked test with the smallest f, -1 when none was asked
};

/// `shrink` in (0, 1]: size of the copy about the centroid. `reach` > 0, a length: samples farther from a
/// shrunk vertex are not asked.
OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                     double shrink, double reach, const NearestSample& samples);
/// The same between any two labels. Where three or more meet nothing is asked: Z has no one normal there.
OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                                     const TetLabels& labels, double shrink, double reach,
                                     const NearestSample& samples);

/// One test of condition 3 on a facet of Z that is no longer the zero of a tetrahedron's function (§2.4): the
/// sample nearest to a shrunk corner must lie on its own side of the facet's plane.
struct FacetOrientationTest {
  Vec3 shrunk;     ///< corner of the copy shrunk about the centroid
  SampleId sample; ///< the nearest of the side `label`; invalid when none is within reach
  int label = +1;
  double agreement = 0; ///< distance of the sample to the plane, positive on the side of its label
  bool good() const { return !sample.valid() || agreement > 0; }
};

/// All six tests; `facet` is counter-clockwise seen from the larger of its labels, `reach` as above.
std::array<FacetOrientationTest, 6> check_facet_orientation(const Triangle3& facet, double shrink,
                                                            double reach, const NearestSample& samples,
                                                            LabelPair labels = {+1, -1});

} // namespace isoscope
