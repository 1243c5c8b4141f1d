// Condition 3 of facets of Z over a plane, whose ∂Ω is known.
#include "criteria/nearest_sample.h"
#include "criteria/orientation.h"
#include "improve/facet_orientation.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

using namespace isoscope;

namespace {

constexpr double delta = 0.1;

/// A wide square in z = 0 with samples of its two boundaries at z = ±0.98 δ, `spacing` apart.
struct Plane {
  explicit Plane(double spacing) : index(square()) {
    for (int i = -20; i <= 20; ++i)
      for (int j = -20; j <= 20; ++j)
        for (const int label : {+1, -1}) {
          positions.push_back({i * spacing, j * spacing, label * 0.98 * delta});
          labels.push_back(static_cast<std::int8_t>(label));
        }
    samples.emplace(positions, labels);
  }
  Plane(const Plane&) = delete;
  Plane& operator=(const Plane&) = delete;
  OrientationTester tester() const { return {&*samples, 0.7, 2.5 * delta, &index, delta}; }

  ClosestPointIndex index;
  std::vector<Vec3> positions;
  std::vector<std::int8_t> labels;
  std::optional<NearestSample> samples;

 private:
  static TriangleSoup square() {
    TriangleSoup soup;
    soup.points = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}};
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    return soup;
  }
};

/// A facet inside Ω that is tilted by `degrees` about an axis turned by `turn`.
Triangle3 tilted(double degrees, double turn, Vec3 center) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec3 along{std::cos(turn), std::sin(turn), 0};
  const Vec3 up{-std::sin(turn) * std::cos(angle), std::cos(turn) * std::cos(angle), std::sin(angle)};
  const double height = 0.95 * delta / std::max(0.2, std::abs(std::sin(angle)));
  return {center - 0.3 * along - height * up, center + 0.3 * along - height * up, center + height * up};
}

} // namespace

TEST_CASE("over a plane no facet tilted by less than 90 degrees fails, however sparse the samples are") {
  const Plane plane(delta);
  std::size_t judged_by_samples = 0;
  for (const double degrees : {0., 20., 40., 60., 75., 85.})
    for (int i = 0; i < 12; ++i) {
      const Triangle3 facet = tilted(degrees, 0.5 * i, {0.013 * i, 0.029 * i, 0});
      CHECK(plane.tester().failures(facet).empty());
      for (const auto& test : check_facet_orientation(facet, 0.7, 2.5 * delta, *plane.samples))
        judged_by_samples += test.good() ? 0u : 1u;
    }
  // The samples themselves lie up to δ/√2 beside the nearest point of ∂Ω, and are then wrong.
  CHECK(judged_by_samples > 0);
}

TEST_CASE("a facet turned over fails all six tests, at points of ∂Ω") {
  const Plane plane(delta / 2);
  for (const double degrees : {120., 150., 180.}) {
    const auto failures = plane.tester().failures(tilted(degrees, 0.3, {0.02, 0.01, 0}));
    CHECK(failures.size() == 6);
    for (const SideSample& s : failures) CHECK(s.point.z == doctest::Approx(s.label * delta));
  }
}
