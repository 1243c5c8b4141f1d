// Sheets of points: B by balls, the two sides of what is left, and the curves where they meet.
#include "tolerance/ball_test.h"
#include "tolerance/point_sheets.h"
#include "tolerance/rim_curves.h"
#include "tolerance/weighted_points.h"

#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

constexpr double delta = 0.1, spacing = 0.02;

/// Points of a grid over the square [-1, 1]², without those in a square hole of this half side.
Result<ToleranceVolume> square_volume(double hole) {
  std::vector<WeightedPoint> sites;
  for (int i = -50; i <= 50; ++i)
    for (int j = -50; j <= 50; ++j)
      if (const Vec3 p{spacing * i, spacing * j, 0}; std::max(std::abs(p.x), std::abs(p.y)) >= hole)
        sites.push_back({p, 0});
  InputTopology topology;
  topology.side_rule = SideRule::depth;
  return ToleranceVolume::build(std::make_shared<const WeightedPointIndex>(sites, 4.0), topology,
                                {.delta = delta}, RunControl());
}

/// How far a place is from the border of a square of this half side around the origin.
double to_square(Vec3 p, double half) {
  return std::abs(std::max(std::abs(p.x), std::abs(p.y)) - half);
}

} // namespace

TEST_CASE("balls find B along the ends of a sheet only, and its two sides") {
  auto volume = square_volume(0.4);
  REQUIRE(volume.ok());
  const double boundary = volume->thresholds().boundary;
  const auto samples = sample_boundary(*volume, 0.25 * boundary, RunControl());
  REQUIRE(samples.ok());
  const std::array<std::uint8_t, 1> sheets{1};
  std::size_t before = 0;
  for (const double gamma : {1.3, 2.0}) {
    const auto told = tell_sheet_sides(*volume, *samples, sheets, gamma, RunControl());
    REQUIRE(told.ok());
    CHECK(told->boundary_samples > before); // the larger the balls, the more of them
    CHECK(told->boundary_samples < samples->size());
    before = told->boundary_samples;
    std::size_t plus = 0, wrong = 0;
    const int up = told->labels[static_cast<std::size_t>(
        std::max_element(samples->positions.begin(), samples->positions.end(),
                         [](Vec3 a, Vec3 b) { return a.z < b.z; }) -
        samples->positions.begin())];
    for (std::size_t i = 0; i < samples->size(); ++i) {
      const Vec3 p = samples->positions[i];
      plus += told->labels[i] > 0;
      wrong += std::abs(p.z) > 0.5 * boundary && told->labels[i] != (p.z > 0 ? up : -up);
    }
    CHECK(wrong == 0);
    CHECK(2 * plus >= samples->size()); // outside is the larger side

    const auto curves = find_rim_curves(*volume, *samples, told->labels, RunControl());
    REQUIRE(curves.ok());
    REQUIRE(curves->size() == 2);
    for (const RimCurve& curve : *curves) {
      const bool outer = std::max(std::abs(curve.corners[0].x), std::abs(curve.corners[0].y)) > 0.7;
      for (std::size_t i = 0; i < curve.corners.size(); ++i) {
        CHECK(to_square(curve.corners[i], outer ? 1 : 0.4) < 0.75 * boundary); // at corners
        CHECK(std::abs(curve.corners[i].z) < 0.2 * boundary);
        const Vec3 p = curve.corners[i];
        CHECK((dot(curve.away[i], p) > 0) == outer);
      }
    }
  }
}

TEST_CASE("the side of a point is that of the nearest sample, and none over the rim") {
  auto volume = square_volume(0);
  REQUIRE(volume.ok());
  const std::vector<std::uint8_t> sheets{1};
  const std::array gammas{2.0};
  auto found = find_point_sheets(*volume, sheets, gammas, RunControl());
  REQUIRE(found.ok());
  volume->open(found->sides, RunControl());
  const OpenSides& sides = *volume->open_sides();
  CHECK(sides.by_samples());
  CHECK(sides.all_open());
  CHECK(sides.rim().loops().size() == 1);
  const auto side = [&](Vec3 p) { return sides.side(p, volume->field().closest(p)); };
  const int up = side({0, 0, 0.3});
  REQUIRE(up != 0);
  for (const double z : {0.02, 0.09, 0.3, 2.0}) {
    CHECK(side({0.3, -0.4, z}) == up);
    CHECK(side({0.3, -0.4, -z}) == -up);
    CHECK(volume->label_at({0.3, -0.4, 0.1 + z}) == up);
  }
  CHECK(side({1.2, 0, 0.01}) == 0);
  CHECK(side({0, -1.5, 0.3}) == 0);
  const auto samples = sample_boundary(*volume, 0.5 * delta, RunControl());
  REQUIRE(samples.ok());
  CHECK(!samples->over_rim.empty());
  for (std::size_t i = 0; i < samples->size(); ++i)
    CHECK(samples->labels[i] == (samples->positions[i].z > 0 ? up : -up));
  for (const Vec3 p : samples->over_rim) CHECK(to_square(p, 1) < 2 * delta);
}
