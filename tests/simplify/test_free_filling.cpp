// The least triangulations of polygons, and what may not be an edge of them.
#include "base/geometry.h"
#include "simplify/free_filling.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace isoscope;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const auto everything = [](std::size_t, std::size_t) { return false; };

double area_of(const std::vector<Vec3>& polygon, const Triangles& triangles) {
  double sum = 0;
  for (const auto& t : triangles) sum += area({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
  return sum;
}

/// Each corner is used, each side of the polygon once in its direction, each other edge once either way.
void check_disc(std::size_t n, const Triangles& triangles) {
  REQUIRE(triangles.size() == n - 2);
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  for (const auto& [a, b] : edges) {
    CHECK(edges.count({a, b}) == 1);
    const bool side = b == (a + 1) % n;
    CHECK(edges.count({b, a}) == (side ? 0u : 1u));
  }
}

std::vector<Vec3> regular(std::size_t n) {
  std::vector<Vec3> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    polygon.push_back({std::cos(turn), std::sin(turn), 0});
  }
  return polygon;
}

} // namespace

TEST_CASE("A polygon is triangulated without further corners") {
  for (const std::size_t n : {3u, 4u, 7u, 40u}) {
    CAPTURE(n);
    const auto polygon = regular(n);
    check_disc(n, least_triangulation(polygon, everything));
  }
  CHECK(least_triangulation(std::vector<Vec3>(2), everything).empty());
  CHECK(least_triangulation(regular(401), everything).empty());
}

TEST_CASE("Of all triangulations that of the least area is taken: a reentrant corner stays one") {
  const std::vector<Vec3> arrow{{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}};
  const auto triangles = least_triangulation(arrow, everything);
  check_disc(4, triangles);
  CHECK(area_of(arrow, triangles) == doctest::Approx(2));
  const std::vector<Vec3> bent{{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}};
  CHECK(area_of(bent, least_triangulation(bent, everything)) == doctest::Approx(2 * std::sqrt(6.0)));
}

TEST_CASE("An edge that the surface has is none of what fills") {
  const auto square = regular(4);
  const auto other =
      least_triangulation(square, [](std::size_t i, std::size_t k) { return i == 0 && k == 2; });
  check_disc(4, other);
  for (const auto& t : other)
    CHECK(std::set<std::uint32_t>(t.begin(), t.end()).count(0) +
              std::set<std::uint32_t>(t.begin(), t.end()).count(2) ==
          1);
  CHECK(least_triangulation(square, [](std::size_t, std::size_t) { return true; }).empty());
}
