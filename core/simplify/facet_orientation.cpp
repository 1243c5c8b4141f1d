// Six nearest samples against one plane.
#include "simplify/facet_orientation.h"

namespace isoscope {

std::vector<SideSample> OrientationTester::failures(const Triangle3& facet) const {
  const Vec3 centroid = (facet[0] + facet[1] + facet[2]) / 3.0;
  const Vec3 normal = cross(facet[1] - facet[0], facet[2] - facet[0]);
  std::vector<SideSample> failed;
  for (const Vec3 corner : facet) {
    const Vec3 shrunk = centroid + shrink * (corner - centroid);
    for (const int label : {+1, -1}) {
      const SampleId id = samples->nearest_of(shrunk, label);
      if (!id.valid()) continue;
      const Vec3 sample = samples->positions()[id.index()];
      if (distance(sample, shrunk) > radius) continue;
      if (label * dot(normal, sample - centroid) <= 0) failed.push_back({sample, double(label)});
    }
  }
  return failed;
}

} // namespace isoscope
