// Condition 3: the nearest samples around the shrunk copy, judged by the tetrahedron's own linear function.
#include "criteria/orientation.h"

namespace isoscope {
namespace {

/// `f` is + on the side of the first label.
OrientationVerdict check_between(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                 LabelPair labels, double shrink, double reach,
                                 const NearestSample& samples) {
  const AffineFunction function = interpolate(p, f);
  const Vec3 centroid = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  OrientationVerdict verdict;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < verdict.tests.size(); ++i) {
    OrientationTest& test = verdict.tests[i];
    test.shrunk = centroid + shrink * (p[i / 2] - centroid);
    test.label = i % 2 == 0 ? labels.front : labels.back;
    test.sample = samples.nearest_of(test.shrunk, test.label, reach);
    if (!test.asked()) continue;
    const double value = function(samples.positions()[test.sample.index()]);
    test.f = i % 2 == 0 ? value : -value;
    if (verdict.worst < 0 || test.f < smallest) {
      verdict.worst = static_cast<int>(i);
      smallest = test.f;
    }
    if (!test.good()) verdict.misoriented = true;
  }
  return verdict;
}

} // namespace

OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                     double shrink, double reach, const NearestSample& samples) {
  return check_between(p, f, {+1, -1}, shrink, reach, samples);
}

OrientationVerdict check_orientation(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                                     const TetLabels& labels, double shrink, double reach,
                                     const NearestSample& samples) {
  if (label_count(labels) > 2) return {};
  const LabelPair pair = outer_labels(labels);
  return check_between(p, seen_from(pair.front, values, labels), pair, shrink, reach, samples);
}

std::array<FacetOrientationTest, 6> check_facet_orientation(const Triangle3& facet, double shrink,
                                                            double reach, const NearestSample& samples,
                                                            LabelPair labels) {
  const Vec3 centroid = isoscope::centroid(facet);
  const Vec3 normal = normalized(cross(facet[1] - facet[0], facet[2] - facet[0]));
  std::array<FacetOrientationTest, 6> tests;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    FacetOrientationTest& test = tests[i];
    test.shrunk = centroid + shrink * (facet[i / 2] - centroid);
    test.label = i % 2 == 0 ? labels.front : labels.back;
    test.sample = samples.nearest_of(test.shrunk, test.label, reach);
    if (!test.sample.valid()) continue;
    const double height = dot(normal, samples.positions()[test.sample.index()] - centroid);
    test.agreement = i % 2 == 0 ? height : -height;
  }
  for (std::size_t i = 0; i < tests.size(); i += 2) {
    if (tests[i].sample.valid() && tests[i + 1].sample.valid()) continue;
    tests[i].sample = tests[i + 1].sample = SampleId();
  }
  return tests;
}

} // namespace isoscope
