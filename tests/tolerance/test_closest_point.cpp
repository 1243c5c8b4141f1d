// Closest points against brute force; parity, crossings and box queries against known answers.
#include "tolerance/closest_point.h"

#include "tolerance/index_building.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::Random;

namespace {

double brute_force(const TriangleSoup& soup, Vec3 p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    best = std::min(best, distance(p, closest_point_on_triangle(p, soup.triangle(i))));
  return best;
}

TriangleSoup random_soup(Random& random, std::size_t n, Vec3 offset, double scale) {
  TriangleSoup soup;
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec3 a = random.in_box(box), u = 0.3 * random.direction(), v = 0.3 * random.direction();
    Triangle3 t{a, a + u, a + v};
    if (i % 7 == 3) t[2] = a + 0.4 * u;                // a segment
    if (i % 11 == 5) t[1] = t[2] = a;                  // a point
    if (i % 13 == 6) t[2] = a + 0.5 * u + 1e-9 * v;    // a needle
    if (i % 5 == 0 && i > 0) t = soup.triangle(i - 1); // a duplicate
    for (const Vec3 p : t) soup.points.push_back(offset + scale * p);
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    if (i % 5 == 0 && i > 0)
      for (std::size_t k = 0; k < 3; ++k) soup.points[3 * i + k] = soup.points[3 * (i - 1) + k];
  }
  return soup;
}

} // namespace

TEST_CASE("closest points equal those of brute force on soups of every size and place") {
  Random random(1);
  for (const std::size_t n : {1u, 2u, 5u, 33u, 400u})
    for (const double scale : {1.0, 1e-12, 1e12})
      for (const double shift : {0.0, 1000.0}) {
        const TriangleSoup soup = random_soup(random, n, scale * Vec3{shift, -shift, shift}, scale);
        const ClosestPointIndex index(soup);
        REQUIRE(index.size() == n);
        for (int i = 0; i < 100; ++i) {
          const double spread = i % 10 == 0 ? 50 : 1.5;
          const Vec3 p = index.bounds().center() + spread * scale * random.unit() * random.direction();
          const double expected = brute_force(soup, p), slack = 1e-12 * (expected + scale * (1 + shift));
          const ClosestPoint found = index.closest(p);
          REQUIRE(found.triangle.valid());
          CHECK(std::abs(found.distance() - expected) <= slack);
          CHECK(std::abs(distance(p, found.point) - found.distance()) <= slack);
          const ClosestPoint guessed = index.closest_near(p, TriangleId(random.below(n)));
          CHECK(std::abs(guessed.distance() - expected) <= slack);
          const double enough = random.unit() * 3 * expected;
          const ClosestPoint near = index.closest_near(p, {}, enough);
          CHECK(std::abs(distance(p, near.point) - near.distance()) <= slack);
          CHECK(near.distance() <= std::max(enough, expected) + slack);
          CHECK_FALSE(index.closest_within(p, expected * (1 - 1e-9) - slack).triangle.valid());
          CHECK(index.closest_within(p, expected * (1 + 1e-9) + slack).triangle.valid());
        }
      }
}

TEST_CASE("a triangle's faces, edges and corners are told apart") {
  const Triangle3 t{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
  CHECK(closest_point_on_triangle({1, 1, 5}, t) == Vec3{1, 1, 0});
  CHECK(closest_point_on_triangle({-1, -1, 2}, t) == Vec3{0, 0, 0});
  CHECK(closest_point_on_triangle({7, -1, 2}, t) == Vec3{4, 0, 0});
  CHECK(closest_point_on_triangle({2, -3, 1}, t) == Vec3{2, 0, 0});
  CHECK(closest_point_on_triangle({4, 4, 1}, t) == Vec3{2, 2, 0});
}

TEST_CASE("triangles within a distance of each other are recognised") {
  const Triangle3 t{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const auto shifted = [&](Vec3 by) { return Triangle3{t[0] + by, t[1] + by, t[2] + by}; };
  CHECK(triangles_within(t, shifted({0, 0, 0.5}), 0.5));
  CHECK_FALSE(triangles_within(t, shifted({0, 0, 0.5}), 0.499));
  CHECK(triangles_within(t, {Vec3{0.2, 0.2, -1}, Vec3{0.2, 0.2, 1}, Vec3{0.3, 0.2, 1}}, 0));
  CHECK_FALSE(triangles_within(t, shifted({2, 0, 0}), 0.99));
  CHECK(triangles_within(t, shifted({2, 0, 0}), 1));
}

TEST_CASE("parity tells inside from outside, also in nested boxes") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {4, 4, 4});
  testing::add_box(soup, {1, 1, 1}, {3, 3, 3});
  const ClosestPointIndex index(soup);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in_box({{-1, -1, -1}, {5, 5, 5}});
    const auto in = [&](double lo, double hi) {
      return p.x > lo && p.y > lo && p.z > lo && p.x < hi && p.y < hi && p.z < hi;
    };
    CHECK(index.inside_by_parity(p) == (in(0, 4) && !in(1, 3)));
  }
  CHECK(index.inside_by_parity({0.5, 0.5, 0.5}));
  CHECK_FALSE(index.inside_by_parity({2, 2, 2}));
}

TEST_CASE("crossings along a segment are ascending and complete") {
  TriangleSoup soup;
  testing::add_box(soup, {0, 0, 0}, {4, 4, 4});
  testing::add_box(soup, {1, 1, 1}, {3, 3, 3});
  const ClosestPointIndex index(soup);
  const std::vector<double> t = index.crossings({-1, 2.1, 2.2}, {5, 2.1, 2.2});
  REQUIRE(t.size() == 4);
  const double expected[] = {1 / 6.0, 2 / 6.0, 4 / 6.0, 5 / 6.0};
  for (std::size_t i = 0; i < 4; ++i) CHECK(t[i] == doctest::Approx(expected[i]));
  CHECK(index.crossings({-1, 2.1, 2.2}, {-0.5, 2.1, 2.2}).empty());
  CHECK(index.crossings({0.5, 2.1, 2.2}, {0.9, 2.1, 2.2}).empty());
}

TEST_CASE("box queries return exactly the triangles whose boxes meet") {
  Random random(3);
  const TriangleSoup soup = random_soup(random, 300, {}, 1);
  const ClosestPointIndex index(soup);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = random.in_box({{-1, -1, -1}, {1, 1, 1}});
    const Box3 box{p, p + Vec3{0.3, 0.2, 0.1}};
    std::vector<TriangleId> expected;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      Box3 b;
      for (const Vec3 v : soup.triangle(t)) b.add(v);
      bool meet = true;
      for (int a = 0; a < 3; ++a) meet = meet && b.lo[a] <= box.hi[a] && b.hi[a] >= box.lo[a];
      if (meet) expected.push_back(TriangleId(t));
    }
    CHECK(index.triangles_in(box) == expected);
  }
}

TEST_CASE("An index without triangles answers every question at once: there is nothing") {
  const ClosestPointIndex index(TriangleSoup{});
  const Vec3 p{1, -2, 3};
  CHECK(index.empty());
  CHECK(index.size() == 0);
  CHECK_FALSE(index.closest(p).triangle.valid());
  CHECK_FALSE(index.closest_within(p, 5).triangle.valid());
  CHECK_FALSE(index.closest_near(p, TriangleId()).triangle.valid());
  CHECK(std::isinf(index.distance(p)));
  TriangleNeighborhood near;
  index.find_neighborhood(p, 1, near);
  CHECK(near.entries.empty());
  CHECK_FALSE(index.closest_near(p, {}, near).triangle.valid());
  CHECK_FALSE(index.inside_by_parity(p));
  CHECK(index.crossings(p, {}).empty());
  CHECK(index.triangles_in({{-9, -9, -9}, {9, 9, 9}}).empty());
}

TEST_CASE("Building an index can be stopped, and what is left finds nothing") {
  TriangleSoup soup;
  isoscope::testing::add_sphere(soup, {0, 0, 0}, 1, 60);
  RunControl control;
  const auto whole = build_index(soup, control);
  CHECK(whole->size() == soup.triangles.size());
  CHECK(whole->distance({2, 0, 0}) == ClosestPointIndex(soup).distance({2, 0, 0}));
  control.cancel();
  const auto stopped = build_index(soup, control);
  CHECK(stopped->empty());
  CHECK_FALSE(stopped->closest({2, 0, 0}).triangle.valid());
}
