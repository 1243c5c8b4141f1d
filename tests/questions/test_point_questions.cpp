// What stands for a point: its neighbours, their mean, its ball, and why it was dropped.
#include "questions/point_questions.h"

#include "tolerance/weighted_points.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;

namespace {

/// Five points on a line and one far away; k = 3 at δ = 2. The last one is dropped.
Scene line_of_points() {
  auto soup = std::make_shared<TriangleSoup>();
  for (const double x : {0.0, 1.0, 2.0, 3.0, 4.0, 100.0}) soup->points.push_back({x, 0, 0});
  auto field = std::make_shared<PointField>();
  field->points = soup;
  field->neighbors = 3;
  field->point = {0, 1, 2, 3, 4};
  const double inner = 2.0 / 3; // of three neighbours at distance 1
  const std::vector<WeightedPoint> sites{
      {{1, 0, 0}, inner}, {{1, 0, 0}, inner}, {{2, 0, 0}, inner}, {{3, 0, 0}, inner}, {{3, 0, 0}, inner}};
  Scene scene;
  scene.input = soup;
  scene.points = field;
  scene.field = std::make_shared<const WeightedPointIndex>(sites, 1.0);
  scene.delta = 2;
  return scene;
}

} // namespace

TEST_CASE("a point is answered with its neighbours, itself first, and with its site") {
  const Scene scene = line_of_points();
  const auto x = inspect_point(scene, 2);
  REQUIRE(x);
  CHECK(x->neighbors == std::vector<std::uint32_t>{2, 1, 3});
  CHECK(x->mean == Vec3{2, 0, 0});
  CHECK(x->weight == doctest::Approx(2.0 / 3));
  CHECK(x->kept);
  CHECK(x->ball_radius(scene.delta) == doctest::Approx(std::sqrt(4 - 2.0 / 3)));
  CHECK(x->phi == doctest::Approx(std::sqrt(2.0 / 3)));
}

TEST_CASE("of a dropped point mean and weight are computed, and it has no ball") {
  const Scene scene = line_of_points();
  const auto x = inspect_point(scene, 5);
  REQUIRE(x);
  CHECK_FALSE(x->kept);
  CHECK(x->dropped == DroppedPoints::Why::outliers);
  CHECK(x->neighbors == std::vector<std::uint32_t>{5, 4, 3});
  CHECK(x->mean.x == doctest::Approx(107.0 / 3));
  CHECK(x->weight > scene.delta * scene.delta);
  CHECK(x->ball_radius(scene.delta) == 0);
}

TEST_CASE("a point with little weight that is dropped was part of a blob") {
  Scene scene = line_of_points();
  auto field = std::make_shared<PointField>(*scene.points);
  field->point = {0, 1, 3, 4};
  const double w = 2.0 / 3;
  scene.points = field;
  scene.field = std::make_shared<const WeightedPointIndex>(
      std::vector<WeightedPoint>{{{1, 0, 0}, w}, {{1, 0, 0}, w}, {{3, 0, 0}, w}, {{3, 0, 0}, w}}, 1.0);
  const auto x = inspect_point(scene, 2);
  REQUIRE(x);
  CHECK_FALSE(x->kept);
  CHECK(x->dropped == DroppedPoints::Why::blob);
}

TEST_CASE("there is no answer where there is no such point") {
  Scene scene = line_of_points();
  CHECK_FALSE(inspect_point(scene, 6));
  scene.points.reset();
  CHECK_FALSE(inspect_point(scene, 0));
}
