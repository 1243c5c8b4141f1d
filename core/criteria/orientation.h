// Condition 3: the linear function of a tetrahedron must classify the samples nearest to its shrunk copy
// (§2.3, Figure 4).
#pragma once

#include "base/ids.h"
#include "criteria/nearest_sample.h"
#include "mesh/complex.h"

#include <array>

namespace isoscope {

/// One test of condition 3: a shrunk vertex, the nearest sample of one side, f there.
struct OrientationTest {
  Vec3 shrunk;     ///< vertex of the shrunk copy
  SampleId sample; ///< the nearest sample of the side `label`
  int label = +1;
  double f = 0; ///< the tetrahedron's function extrapolated to the sample
  bool good() const { return f * label > 0; }
};

/// All eight tests (four vertices, both sides); a tetrahedron is misoriented when one is not good.
struct OrientationVerdict {
  std::array<OrientationTest, 8> tests;
  bool misoriented = false;
  int worst = -1; ///< index of the test with the smallest f·label
};

/// `shrink` in (0, 1]: size of the copy about the centroid. Needs samples on both sides in the index.
OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                     double shrink, const NearestSample& samples);

} // namespace isoscope
