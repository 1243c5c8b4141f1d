// The witnessed k-distance: sites by brute force, its bound, the choice of k, samples of triangles.
#include "tolerance/witnessed_distance.h"

#include "base/parallel.h"
#include "support/clouds.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

const Box3 cube{{-1, -1, -1}, {1, 1, 1}};

/// The points from near to far from p.
std::vector<Vec3> by_distance(std::vector<Vec3> points, Vec3 p) {
  std::sort(points.begin(), points.end(),
            [&](Vec3 a, Vec3 b) { return squared_length(a - p) < squared_length(b - p); });
  return points;
}

} // namespace

TEST_CASE("sites are the means of the nearest points and their deviations") {
  Random random(1);
  std::vector<Vec3> points;
  add_outliers(random, points, 300, cube);
  for (const std::size_t k : {2u, 5u, 12u, 300u, 999u}) {
    const WitnessedDistance found = witness_distance(points, k, RunControl());
    REQUIRE(found.sites.size() == points.size());
    CHECK(found.neighbors == std::min<std::size_t>(k, 300));
    for (std::size_t i = 0; i < points.size(); i += 7) {
      const std::vector<Vec3> near = by_distance(points, points[i]);
      Vec3 mean;
      const auto n = static_cast<double>(found.neighbors);
      for (std::size_t j = 0; j < found.neighbors; ++j) mean += near[j] / n;
      double weight = 0;
      for (std::size_t j = 0; j < found.neighbors; ++j) weight += squared_length(near[j] - mean) / n;
      CHECK(distance(found.sites[i].center, mean) < 1e-12);
      CHECK(found.sites[i].weight == doctest::Approx(weight));
    }
  }
}

TEST_CASE("the plain distance has the points themselves as sites, twice the same ones too") {
  Random random(2);
  std::vector<Vec3> points;
  add_outliers(random, points, 50, cube);
  points.push_back(points[3]);
  const WitnessedDistance found = witness_distance(points, 1, RunControl());
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(found.sites[i].center == points[i]);
    CHECK(found.sites[i].weight == 0);
  }
}

TEST_CASE("φ is nowhere below the distance to the measure of the points") {
  Random random(3);
  const std::vector<Vec3> points = sphere_points(random, 600, 1, 0.02);
  const WitnessedDistance found = witness_distance(points, 8, RunControl());
  const WeightedPointIndex index(found.sites, found.area);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = 1.3 * random.in_box(cube);
    const std::vector<Vec3> near = by_distance(points, p);
    double squared = 0;
    for (std::size_t j = 0; j < 8; ++j) squared += squared_length(near[j] - p) / 8;
    CHECK(index.distance(p) >= std::sqrt(squared) * (1 - 1e-12));
  }
}

TEST_CASE("k goes with the share of points that stand apart; area and spacing are those of the surface") {
  Random random(4);
  std::vector<Vec3> points = sphere_points(random, 4000, 1, 0.005);
  const Box3 box{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};
  const double area = 4 * std::numbers::pi;
  const WitnessedDistance clean = witness_distance(points, 0, RunControl());
  CHECK(clean.neighbors == usual_neighbors);
  CHECK(clean.automatic);
  CHECK(clean.outlying < 0.001);
  CHECK(clean.area == doctest::Approx(area).epsilon(0.2));
  CHECK(clean.spacing == doctest::Approx(std::sqrt(area / 4000)).epsilon(0.2));
  add_outliers(random, points, 400, box);
  const WitnessedDistance noisy = witness_distance(points, 0, RunControl());
  CHECK(noisy.neighbors == robust_neighbors);
  CHECK(noisy.outlying > 0.05);
  CHECK(noisy.outlying < 0.1);
  CHECK(noisy.area < 1.5 * area);
}

TEST_CASE("sites are the same bits on any number of threads, and finding them can be stopped") {
  Random random(5);
  const std::vector<Vec3> points = sphere_points(random, 3000, 1, 0.01);
  std::vector<WeightedPoint> first;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const ThreadLimit limit(threads);
    const WitnessedDistance found = witness_distance(points, 12, RunControl());
    if (first.empty()) first = found.sites;
    for (std::size_t i = 0; i < points.size(); ++i) {
      REQUIRE(found.sites[i].center == first[i].center);
      REQUIRE(found.sites[i].weight == first[i].weight);
    }
  }
  RunControl control;
  control.cancel();
  CHECK(witness_distance(points, 12, control).area == 0);
}

TEST_CASE("samples of triangles are even, on the triangles and go with the seed") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {4, 1, 1});
  const std::vector<Vec3> points = sample_area(soup, 1800, 7);
  REQUIRE(points.size() == 1800);
  std::size_t at_end = 0; // the faces x = 0 and x = 4 have a ninth of the area
  for (const Vec3 p : points) {
    const bool on_end = p.x < 1e-12 || p.x > 4 - 1e-12;
    const bool on_side = p.y < 1e-12 || p.y > 1 - 1e-12 || p.z < 1e-12 || p.z > 1 - 1e-12;
    CHECK((on_end || on_side));
    at_end += on_end ? 1 : 0;
  }
  CHECK(at_end >= 196);
  CHECK(at_end <= 204);
  CHECK(sample_area(soup, 1800, 7) == points);
  CHECK(sample_area(soup, 1800, 8) != points);
}
