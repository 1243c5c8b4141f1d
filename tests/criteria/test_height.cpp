// Heights of hand-made tetrahedra in both splits, and their relation to the gradient of f.
#include "criteria/height.h"

#include "mesh/complex.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

constexpr std::array<Vec3, 4> unit{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

} // namespace

TEST_CASE("an apex over its base: the distance to the plane") {
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}, Vec3{7, -3, 2.5}};
  for (const double sign : {+1.0, -1.0}) {
    const Height h = tetrahedron_height(p, {sign, sign, sign, -sign});
    CHECK(h.split == Height::Split::one_three);
    CHECK(h.value == doctest::Approx(2.5));
    CHECK(h.order[0] == 3);
  }
}

TEST_CASE("two against two: the distance of the lines") {
  const std::array<Vec3, 4> p{Vec3{-1, 0, 0}, Vec3{5, 0, 0}, Vec3{2, -1, 0.75}, Vec3{3, 8, 0.75}};
  const Height h = tetrahedron_height(p, {1, 1, -1, -1});
  CHECK(h.split == Height::Split::two_two);
  CHECK(h.value == doctest::Approx(0.75));
  CHECK(h.order == std::array<std::uint8_t, 4>{0, 1, 2, 3});
  const Height turned = tetrahedron_height({p[2], p[0], p[3], p[1]}, {-1, 1, -1, 1});
  CHECK(turned.value == doctest::Approx(0.75));
  CHECK(turned.order == std::array<std::uint8_t, 4>{1, 3, 0, 2});
}

TEST_CASE("one label has no height") {
  CHECK(tetrahedron_height(unit, {1, 1, 1, 1}).split == Height::Split::none);
  CHECK(tetrahedron_height(unit, {-1, -1, -1, -1}).split == Height::Split::none);
}

TEST_CASE("the height is twice the inverse of the gradient's length for labels of one size") {
  const std::array<Vec3, 4> p{Vec3{0.1, 0.3, -1}, Vec3{2, 0.2, 0.4}, Vec3{-0.5, 1.7, 0.3},
                              Vec3{0.6, 0.5, 1.9}};
  for (unsigned mask = 1; mask < 15; ++mask) {
    std::array<double, 4> f{};
    for (unsigned i = 0; i < 4; ++i) f[i] = (mask >> i) & 1u ? 1 : -1;
    CHECK(tetrahedron_height(p, f).value == doctest::Approx(2 / length(interpolate(p, f).gradient)));
  }
}

TEST_CASE("flat tetrahedra have no height instead of an undefined one") {
  const std::array<Vec3, 4> line{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{3, 0, 0}};
  CHECK(tetrahedron_height(line, {1, 1, 1, -1}).value == 0);
  CHECK(tetrahedron_height(line, {1, 1, -1, -1}).value == 0);
}
