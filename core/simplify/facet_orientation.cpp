// Keeps what failed of the six tests.
#include "simplify/facet_orientation.h"

#include "criteria/orientation.h"

namespace isoscope {

/// The sample moved away from the input to d = δ.
Vec3 OrientationTester::on_boundary(Vec3 sample) const {
  const ClosestPoint closest = index->closest(sample);
  const double d = closest.distance();
  return d > 0 && d < delta ? closest.point + (delta / d) * (sample - closest.point) : sample;
}

std::vector<SideSample> OrientationTester::failures(const Triangle3& facet) const {
  std::vector<SideSample> failed;
  const Vec3 normal = normalized(cross(facet[1] - facet[0], facet[2] - facet[0]));
  for (const FacetOrientationTest& test : check_facet_orientation(facet, shrink, radius, *samples)) {
    if (test.good()) continue;
    const Vec3 p = on_boundary(samples->positions()[test.sample.index()]);
    if (test.label * dot(normal, p - facet[0]) > 0) continue;
    failed.push_back({p, double(test.label)});
  }
  return failed;
}

} // namespace isoscope
