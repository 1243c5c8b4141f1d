// Signs are exact, antisymmetric and never undecided for proper triangles.
#include "mesh/predicates.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace isoscope;

TEST_CASE("orientation is exact where doubles cancel") {
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(orientation(o, x, y, z) == 1);
  CHECK(orientation(o, y, x, z) == -1);
  const double tiny = std::ldexp(1.0, -1000);
  CHECK(orientation(o, x, y, {0.5, 0.25, tiny}) == 1);
  CHECK(orientation(o, x, y, {0.5, 0.25, -tiny}) == -1);
  CHECK(orientation(o, x, y, {0.5, 0.25, 0}) == 0);
  const double up = std::nextafter(0.3, 1.0);
  CHECK(orientation({0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.2, 0.9, 0.4}, {0.3, 0.3, 0.3}) == 0);
  CHECK(orientation({0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.2, 0.9, 0.4}, {0.3, 0.3, up}) != 0);
}

TEST_CASE("the sphere test knows inside, on and outside") {
  const Vec3 a{25, 0, 0}, b{0, 25, 0}, c{-25, 0, 0}, d{0, 0, 25};
  REQUIRE(orientation(a, b, c, d) == 1);
  CHECK(side_of_sphere(a, b, c, d, {0, 0, 0}) == 1);
  CHECK(side_of_sphere(a, b, c, d, {15, 16, 12}) == 0);
  CHECK(side_of_sphere(a, b, c, d, {15, 16, std::nextafter(12.0, 13.0)}) == -1);
  CHECK(side_of_sphere(a, b, c, d, {15, 16, std::nextafter(12.0, 11.0)}) == 1);
}

TEST_CASE("a perturbed point lies on exactly one side, the opposite one seen from behind") {
  test::Random random(11);
  for (int i = 0; i < 2000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& q : p) q = {double(random.below(4)), double(random.below(4)), double(random.below(4))};
    if (squared_length(cross(p[1] - p[0], p[2] - p[0])) == 0) continue;
    const int side = orientation_perturbed(p[0], p[1], p[2], p[3]);
    CHECK(side != 0);
    CHECK(orientation_perturbed(p[1], p[2], p[0], p[3]) == side);
    CHECK(orientation_perturbed(p[1], p[0], p[2], p[3]) == -side);
    CHECK(orientation_perturbed(p[2], p[1], p[0], p[3]) == -side);
    const int plain = orientation(p[0], p[1], p[2], p[3]);
    if (plain != 0) CHECK(plain == side);
  }
}

TEST_CASE("a plane along the fixed direction is decided by the next one, the same from all corners") {
  const Vec3 o{}, along{0.6180339887498949, 0.3819660113183213, 0.6871214994603411};
  test::Random random(12);
  for (int i = 0; i < 500; ++i) {
    const Vec3 c = random.in({{-1, -1, -1}, {1, 1, 1}});
    const int side = orientation_perturbed(o, along, c, o);
    CHECK(side != 0);
    CHECK(orientation_perturbed(along, c, o, o) == side);
    CHECK(orientation_perturbed(c, o, along, o) == side);
    CHECK(orientation_perturbed(along, o, c, o) == -side);
    CHECK(orientation_perturbed(o, along, -c, o) == -side);
  }
}
