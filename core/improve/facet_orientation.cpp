// Keeps what fails of the six tests.
#include "improve/facet_orientation.h"

#include "criteria/orientation.h"

namespace isoscope {

Vec3 OrientationTester::on_boundary(Vec3 x) const {
  return field->at_level(x, field->closest(x), delta).value_or(x);
}

Vec3 OrientationTester::nearest_on_boundary(Vec3 x, Vec3 sample) const {
  // A sample is about σ off at most, and a step of δ / 2 along ∂Ω does not cross the input.
  constexpr int most_steps = 4;
  const double longest_step = 0.5 * delta, shortest_step = 1e-3 * delta;
  Vec3 nearest = on_boundary(sample);
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 normal = normalized(nearest - field->closest(nearest).point);
    const Vec3 way = x - nearest;
    Vec3 step = way - dot(way, normal) * normal;
    const double l = length(step);
    if (l < shortest_step) break;
    if (l > longest_step) step = (longest_step / l) * step;
    const Vec3 next = on_boundary(nearest + step);
    if (!(distance(next, x) < distance(nearest, x))) break;
    nearest = next;
  }
  return nearest;
}

std::vector<SideSample> OrientationTester::failures(const Triangle3& facet, LabelPair labels) const {
  std::vector<SideSample> failed;
  const Vec3 normal = normalized(cross(facet[1] - facet[0], facet[2] - facet[0]));
  for (const FacetOrientationTest& test : check_facet_orientation(facet, shrink, radius, *samples, labels)) {
    if (test.good()) continue;
    const Vec3 p = nearest_on_boundary(test.shrunk, samples->positions()[test.sample.index()]);
    const double side = test.label == labels.front ? 1 : -1;
    if (side * dot(normal, p - facet[0]) > 0) continue;
    failed.push_back({p, side});
  }
  return failed;
}

} // namespace isoscope
