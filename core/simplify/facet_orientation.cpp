// Keeps what failed of the six tests.
#include "simplify/facet_orientation.h"

#include "criteria/orientation.h"

namespace isoscope {

std::vector<SideSample> OrientationTester::failures(const Triangle3& facet) const {
  std::vector<SideSample> failed;
  for (const FacetOrientationTest& test : check_facet_orientation(facet, shrink, radius, *samples)) {
    if (!test.good()) failed.push_back({samples->positions()[test.sample.index()], double(test.label)});
  }
  return failed;
}

} // namespace isoscope
