// Builds start surfaces and judges results by the run's certificate.
#include "improve/support.h"

#include "run/certificate.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

namespace isoscope::testing {

Start::Start(const TriangleSoup& input, double percent) : soup(input), mesh{input.points, input.triangles} {
  auto index = std::make_shared<const ClosestPointIndex>(soup);
  const double delta = percent / 100 * index->bounds().longest_edge();
  RunControl control;
  auto built = ToleranceVolume::build(index, analyse_input(soup), {delta, 0.95}, control);
  REQUIRE_MESSAGE(built.ok(), built.error().line());
  volume = std::make_unique<ToleranceVolume>(std::move(*built));
}

ImproverOptions with_effort(int effort) {
  ImproverOptions options;
  options.effort = effort;
  return options;
}

bool Listener::accepted(const SurfaceChange& change, const ImproverVerdict& verdict) {
  changes.push_back(change);
  verdicts.push_back(verdict);
  count();
  return stop_after == 0 || changes.size() < stop_after;
}

bool Listener::rejected(const ImproverVerdict& verdict) {
  rejections.push_back(verdict);
  count();
  return true;
}

void Listener::count() {
  if (++calls_ == cancel_after) control->cancel();
}

void check_valid(const TriangleMesh& mesh, const Start& start, long euler_characteristic) {
  ExpectedTopology expected;
  expected.euler_characteristic = euler_characteristic;
  const Certificate c = certify(mesh, *start.volume, expected, RunControl());
  for (const std::string& failure : c.failures) MESSAGE(failure);
  CHECK(c.holds());
}

TriangleSoup octahedron(double r) {
  TriangleSoup soup;
  soup.points = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return soup;
}

TriangleSoup sphere(unsigned n) {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, n);
  return soup;
}

} // namespace isoscope::testing
