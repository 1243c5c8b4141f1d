// Weighted points against brute force: φ, its neighbourhoods, the components of the balls, memory.
#include "tolerance/weighted_points.h"

#include "base/disjoint_sets.h"
#include "tolerance/closest_point.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

const Box3 cube{{-1, -1, -1}, {1, 1, 1}};

std::vector<WeightedPoint> random_points(Random& random, std::size_t n, Vec3 offset, double scale,
                                         double heaviest) {
  std::vector<WeightedPoint> points;
  for (std::size_t i = 0; i < n; ++i) {
    WeightedPoint p{offset + scale * random.in_box(cube), scale * scale * random.between(0, heaviest)};
    if (i % 7 == 3) p.center = points[i / 2].center; // again at the same place
    if (i % 5 == 2) p.weight = 0;
    points.push_back(p);
  }
  return points;
}

double brute_force(const std::vector<WeightedPoint>& points, Vec3 p) {
  double best = std::numeric_limits<double>::infinity();
  for (const WeightedPoint& s : points) best = std::min(best, squared_length(p - s.center) + s.weight);
  return best;
}

} // namespace

TEST_CASE("φ of weighted points equals that of brute force, however it is asked for") {
  Random random(1);
  for (const std::size_t n : {1u, 2u, 5u, 33u, 900u}) {
    for (const double heaviest : {0.0, 0.02, 3.0}) {
      const Vec3 offset = n == 33 ? Vec3{1e4, -3e4, 7e3} : Vec3{};
      const double scale = n == 33 ? 1e-2 : 1;
      const auto points = random_points(random, n, offset, scale, heaviest);
      const WeightedPointIndex index(points, 1);
      REQUIRE(index.size() == n);
      for (int i = 0; i < 200; ++i) {
        const Vec3 p = offset + (i % 4 == 0 ? 30 * scale : 1.5 * scale) * random.in_box(cube);
        const double wanted = brute_force(points, p), rounding = 1e-12 * (wanted + squared_length(offset));
        const ClosestPoint found = index.closest(p);
        CHECK(found.squared_distance <= wanted + rounding);
        CHECK(found.squared_distance == index.at_site(p, found.triangle).squared_distance);
        const TriangleId guess(random.below(n));
        CHECK(index.closest_near(p, guess).squared_distance == found.squared_distance);
        TriangleNeighborhood near;
        const Vec3 center = p + 0.2 * scale * random.in_box(cube);
        index.find_neighborhood(center, index.distance(center) + 0.5 * scale, near);
        CHECK(index.closest_near(p, guess, near).squared_distance == found.squared_distance);
        const double enough = 1.2 * found.distance();
        CHECK(index.closest_near(p, index.at_site(p, guess), enough).distance() <=
              std::max(enough, found.distance()));
      }
    }
  }
}

TEST_CASE("φ of weighted points is 1-Lipschitz, its gradient at most 1, and neighbours bound it from below") {
  Random random(2);
  const auto points = random_points(random, 300, {}, 1, 0.3);
  const WeightedPointIndex index(points, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = 1.5 * random.in_box(cube), q = p + 0.3 * random.in_box(cube);
    const ClosestPoint at = index.closest(p);
    CHECK(std::abs(at.distance() - index.distance(q)) <= distance(p, q) * (1 + 1e-12));
    CHECK(length(index.gradient(p, at)) <= 1 + 1e-12);
    TriangleNeighborhood near;
    index.find_neighborhood(p, at.distance() + 0.2, near);
    double least = near.radius - distance(p, q); // of sites that are not listed
    for (const auto& e : near.entries) {
      CHECK(length(e.direction) <= 1 + 1e-12);
      least = std::min(least, e.distance + dot(e.direction, q - p));
    }
    CHECK(index.distance(q) >= least - 1e-12);
  }
}

TEST_CASE("points without weights have the φ of as many small triangles") {
  Random random(3);
  const auto points = random_points(random, 200, {}, 1, 0);
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    soup.points.push_back(points[i].center);
    soup.triangles.push_back({i, i, i});
  }
  const WeightedPointIndex index(points, 1);
  const ClosestPointIndex triangles(soup);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 2 * random.in_box(cube);
    CHECK(index.distance(p) == doctest::Approx(triangles.distance(p)).epsilon(1e-12));
  }
  CHECK(index.surface() == nullptr);
  CHECK(index.kind() == FieldKind::points);
}

TEST_CASE("components of {φ <= r} are those of the balls") {
  Random random(4);
  const auto points = random_points(random, 400, {}, 1, 0.02);
  const WeightedPointIndex index(points, 1);
  for (const double r : {0.03, 0.08, 0.12, 0.2, 3.0}) {
    const VolumeComponents found = index.components(r, RunControl());
    DisjointSets sets(points.size());
    const auto radius = [&](std::uint32_t i) { return std::sqrt(std::max(0.0, r * r - points[i].weight)); };
    for (std::uint32_t i = 0; i < points.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j)
        if (points[i].weight < r * r && points[j].weight < r * r &&
            distance(points[i].center, points[j].center) <= radius(i) + radius(j))
          sets.unite(i, j);
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (points[i].weight >= r * r) {
        CHECK(found.of_triangle[i] == VolumeComponents::none);
        continue;
      }
      if (sets.find(i) == i)
        CHECK(found.of_triangle[i] == count++); // numbered by their smallest sites
      else
        CHECK(found.of_triangle[i] == found.of_triangle[sets.find(i)]);
    }
    CHECK(found.count == count);
  }
}

TEST_CASE("a hundred bytes a point are enough, and building can be stopped") {
  Random random(5);
  const auto points = random_points(random, 20000, {}, 1, 0.02);
  const WeightedPointIndex index(points, 1);
  CHECK(index.memory_bytes() <= 100 * points.size());
  RunControl control;
  control.cancel();
  const WeightedPointIndex stopped(points, 1, control);
  CHECK(stopped.empty());
  CHECK_FALSE(stopped.closest({2, 0, 0}).triangle.valid());
  CHECK(stopped.components(1, RunControl()).count == 0);
}
