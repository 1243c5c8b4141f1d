// Condition 3: the nearest samples around the shrunk copy, judged by the tetrahedron's own linear function.
#include "criteria/orientation.h"

namespace isoscope {

OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                     double shrink, double reach, const NearestSample& samples) {
  const AffineFunction function = interpolate(p, f);
  const Vec3 centroid = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  OrientationVerdict verdict;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < verdict.tests.size(); ++i) {
    OrientationTest& test = verdict.tests[i];
    test.shrunk = centroid + shrink * (p[i / 2] - centroid);
    test.label = i % 2 == 0 ? +1 : -1;
    test.sample = samples.nearest_of(test.shrunk, test.label, reach);
    if (!test.asked()) continue;
    test.f = function(samples.positions()[test.sample.index()]);
    const double agreement = test.f * test.label;
    if (verdict.worst < 0 || agreement < smallest) {
      verdict.worst = static_cast<int>(i);
      smallest = agreement;
    }
    if (!test.good()) verdict.misoriented = true;
  }
  return verdict;
}

std::array<FacetOrientationTest, 6> check_facet_orientation(const Triangle3& facet, double shrink,
                                                            double reach, const NearestSample& samples) {
  const Vec3 centroid = isoscope::centroid(facet);
  const Vec3 normal = normalized(cross(facet[1] - facet[0], facet[2] - facet[0]));
  std::array<FacetOrientationTest, 6> tests;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    FacetOrientationTest& test = tests[i];
    test.shrunk = centroid + shrink * (facet[i / 2] - centroid);
    test.label = i % 2 == 0 ? +1 : -1;
    test.sample = samples.nearest_of(test.shrunk, test.label, reach);
    if (!test.sample.valid()) continue;
    test.agreement = test.label * dot(normal, samples.positions()[test.sample.index()] - centroid);
  }
  for (std::size_t i = 0; i < tests.size(); i += 2) {
    if (tests[i].sample.valid() && tests[i + 1].sample.valid()) continue;
    tests[i].sample = tests[i + 1].sample = SampleId();
  }
  return tests;
}

} // namespace isoscope
