// Polygons are cut into triangles that cover them once.
#include "input/exact_circle.h"
#include "input/polygon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

using namespace isoscope;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Triangles triangles;
  triangulate_polygon(points, corners, RunControl{}, triangles);
  return triangles;
}

double area_across(const std::vector<Vec3>& points, const Triangles& triangles, Vec3 normal) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * std::abs(dot(normal, cross(points[b] - points[a], points[c] - points[a])));
  return sum;
}

/// A wave of `waves` periods around the circle, `n` corners, in the plane z = x.
std::vector<Vec3> wavy(int n, int waves) {
  std::vector<Vec3> points;
  for (int k = 0; k < n; ++k) {
    const CirclePoint c = circle_point(k, n);
    const double radius = 1 + 0.4 * circle_point(k * waves % n, n).sine;
    points.push_back({radius * c.cosine, radius * c.sine, radius * c.cosine});
  }
  return points;
}

/// The area that a polygon of one turn encloses, seen along z.
double enclosed_area(const std::vector<Vec3>& p) {
  double twice = 0;
  for (std::size_t i = 0, n = p.size(); i < n; ++i)
    twice += p[i].x * p[(i + 1) % n].y - p[i].y * p[(i + 1) % n].x;
  return twice / 2;
}

/// Area and smallest part of it along `normal`: parts of one sign that sum to the polygon's area cover it
/// once.
void check_cover(const std::vector<Vec3>& points, Vec3 normal, double area) {
  const Triangles triangles = cut(points);
  REQUIRE(triangles.size() == points.size() - 2);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double part = 0.5 * dot(normal, cross(points[b] - points[a], points[c] - points[a]));
    CHECK(part > 0);
    sum += part;
  }
  CHECK(sum == doctest::Approx(area));
}

} // namespace

TEST_CASE("convex and notched polygons in any plane") {
  check_cover({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {0, 0, 1}, 2);
  check_cover({{0, 0, 0}, {2, 0, 0}, {0.4, 0.4, 0}, {0, 2, 0}}, {0, 0, 1},
              0.8); // a dart has one valid diagonal
  check_cover({{0, 0, 0}, {0, 0, 2}, {0, 0.4, 0.4}, {0, 2, 0}}, {-1, 0, 0}, 0.8);
  std::vector<Vec3> star;
  for (int k = 0; k < 40; ++k) {
    const CirclePoint c = circle_point(k, 40);
    star.push_back((k % 2 == 0 ? 1.0 : 0.3) * Vec3{c.cosine, 0.6 * c.sine, 0.8 * c.sine});
  }
  check_cover(star, {0, -0.8, 0.6}, 0.5 * 40 * 0.3 * circle_point(1, 40).sine);
}

TEST_CASE("large polygons are covered once too, in whatever plane and direction") {
  for (const int n : {129, 1000, 20000}) {
    std::vector<Vec3> points = wavy(n, 7);
    check_cover(points, {0, 0, 1}, enclosed_area(points));
    std::reverse(points.begin(), points.end());
    check_cover(points, {0, 0, -1}, -enclosed_area(points));
    for (Vec3& p : points) p = {p.z, p.x, p.y};
    check_cover(points, {-1, 0, 0}, area_across(points, cut(points), {-1, 0, 0}));
  }
  // A comb: every edge is long and has many others beside it.
  std::vector<Vec3> comb;
  constexpr int teeth = 3000;
  for (int k = 0; k < teeth; ++k) {
    comb.push_back({2.0 * k, 0, 0});
    comb.push_back({2.0 * k + 1, 1000, 0});
  }
  comb.push_back({2.0 * teeth, 2000, 0});
  comb.push_back({-1, 2000, 0});
  check_cover(comb, {0, 0, 1}, enclosed_area(comb));
}

TEST_CASE("a bridge to a hole, corners that lie on edges and points of the same place") {
  // A ring: the outline, over a bridge into the hole, clockwise around it, and back.
  constexpr int n = 200;
  std::vector<Vec3> points;
  std::vector<std::uint32_t> ring;
  for (int k = 0; k < n; ++k) points.push_back({circle_point(k, n).cosine, circle_point(k, n).sine, 0});
  for (int k = 0; k < n; ++k) points.push_back(0.5 * points[static_cast<std::size_t>(k)]);
  for (int k = 0; k <= n; ++k) ring.push_back(static_cast<std::uint32_t>(k % n));
  for (int k = n; k >= 0; --k) ring.push_back(static_cast<std::uint32_t>(n + k % n));
  Triangles triangles;
  CHECK(triangulate_polygon(points, ring, RunControl{}, triangles));
  CHECK(triangles.size() == ring.size() - 2);
  const double disc = enclosed_area({points.begin(), points.begin() + n});
  CHECK(area_across(points, triangles, {0, 0, 1}) == doctest::Approx(0.75 * disc));

  // A square with its edges cut finely, which comes back to touch its own edge.
  std::vector<Vec3> square;
  for (int k = 0; k < 40; ++k) square.push_back({k / 40.0, 0, 0});
  for (int k = 0; k < 40; ++k) square.push_back({1, k / 40.0, 0});
  for (int k = 0; k < 40; ++k) square.push_back({1 - k / 40.0, 1, 0});
  for (int k = 0; k < 20; ++k) square.push_back({0, 1 - k / 40.0, 0});
  square.push_back({0.3, 0, 0}); // touches the lower edge
  CHECK(area_across(square, cut(square), {0, 0, 1}) == doctest::Approx(enclosed_area(square)));
}

TEST_CASE("large polygons that cross themselves are told and cut at once") {
  std::vector<Vec3> star;
  for (int k = 0; k < 20000; ++k) star.push_back({std::sin(1.0 * k), std::cos(1.7 * k), 0});
  std::vector<std::uint32_t> corners(star.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Triangles triangles;
  CHECK_FALSE(triangulate_polygon(star, corners, RunControl{}, triangles));
  CHECK(triangles.size() == star.size() - 2);
  for (Vec3& p : star) p = {p.x, 0, 0}; // no area at all
  triangles.clear();
  CHECK_FALSE(triangulate_polygon(star, corners, RunControl{}, triangles));
  CHECK(triangles.size() == star.size() - 2);
  RunControl cancelled;
  cancelled.cancel();
  triangles.clear();
  CHECK_FALSE(triangulate_polygon(wavy(20000, 7), corners, cancelled, triangles));
  CHECK(triangles.empty());
}

TEST_CASE("flatness is the distance from the plane of the area vector") {
  const std::vector<std::uint32_t> quad{0, 1, 2, 3};
  CHECK(flatness_deviation(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, quad) == 0);
  CHECK(flatness_deviation(std::vector<Vec3>{{0, 0, 0.1}, {1, 0, -0.1}, {1, 1, 0.1}, {0, 1, -0.1}}, quad) ==
        doctest::Approx(0.1));
  const std::vector<std::uint32_t> triangle{0, 1, 2};
  CHECK(flatness_deviation(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 7}}, triangle) == 0);
}

TEST_CASE("crossing and flat polygons still give their number of triangles") {
  CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size() == 3);
  CHECK(cut({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("the circle of our own is the circle") {
  for (const long n : {1L, 4L, 7L, 48L, 216L, 1000L}) {
    for (long k = -n; k <= n; ++k) {
      const CirclePoint p = circle_point(k, n);
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      CHECK(std::abs(p.cosine - std::cos(angle)) < 1e-15 * 4);
      CHECK(std::abs(p.sine - std::sin(angle)) < 1e-15 * 4);
    }
  }
  CHECK(circle_point(1, 4).cosine == 0);
  CHECK(circle_point(1, 4).sine == 1);
  CHECK(circle_point(1, 8).cosine == doctest::Approx(circle_point(1, 8).sine).epsilon(1e-16));
  CHECK(circle_point(3, 48).sine == -circle_point(-3, 48).sine);
}
