// Polygons are cut into triangles that cover them once.
#include "input/exact_circle.h"
#include "input/polygon.h"

#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

using namespace isoscope;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Triangles triangles;
  triangulate_polygon(points, corners, triangles);
  return triangles;
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
