// Solid angles of soups: exact where a tree may not err, whole numbers where the soup closes, clear near to
// gaps.
#include "base/solid_angle.h"
#include "tolerance/shapes.h"
#include "tolerance/solid_angles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

double summed(const ClosestPointIndex& index, Vec3 p) {
  double angle = 0;
  for (std::uint32_t t = 0; t < index.size(); ++t) angle += solid_angle(p, index.triangle(TriangleId(t)));
  return angle / (4 * std::numbers::pi);
}

} // namespace

TEST_CASE("Solid angles add up past a half and a whole turn, whichever triangle comes first") {
  // The faces of a cube seen from its centre: 2π/3 each, of which three make half a turn of the half angles.
  TriangleSoup cube;
  add_box(cube, {-1, -1, -1}, {1, 1, 1});
  const ClosestPointIndex index(cube);
  for (std::uint32_t first = 0; first < index.size(); ++first) {
    SolidAngleSum sum, reversed, twice;
    for (std::uint32_t k = 0; k < index.size(); ++k) {
      const Triangle3& t =
          index.triangle(TriangleId((first + 5 * k) % static_cast<std::uint32_t>(index.size())));
      sum.add({0, 0, 0}, t);
      reversed.add({0, 0, 0}, t, -1);
      twice.add({0.3, -0.2, 0.9}, t);
      twice.add({0.3, -0.2, 0.9}, t);
    }
    CHECK(sum.winding() == doctest::Approx(1).epsilon(1e-12));
    CHECK(reversed.winding() == doctest::Approx(-1).epsilon(1e-12));
    CHECK(twice.winding() == doctest::Approx(2).epsilon(1e-12));
  }
  SolidAngleSum at_corner;
  at_corner.add({0, 0, 0}, {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}});
  CHECK(at_corner.value() == 0);
}

TEST_CASE("A closed soup winds a whole number of times, whatever holds it together") {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, 24);
  add_sphere(soup, {0.5, 0, 0}, 1, 24);
  const ClosestPointIndex index(soup);
  const SolidAngles angles(index, {});
  CHECK(angles.winding({0.25, 0, 0}) == doctest::Approx(2).epsilon(0.01));
  CHECK(angles.winding({-0.8, 0, 0}) == doctest::Approx(1).epsilon(0.01));
  CHECK(std::abs(angles.winding({3, 1, 0})) < 0.01);
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.in_box(index.bounds().grown(0.5));
    CAPTURE(p.x);
    CHECK(std::abs(angles.winding(p) - summed(index, p)) < 0.01);
  }
  std::vector<std::int8_t> turns(index.size(), 1);
  std::fill(turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2), turns.end(), std::int8_t{-1});
  CHECK(std::abs(SolidAngles(index, turns).winding({0.25, 0, 0})) < 0.01);
  turns.assign(index.size(), 0);
  CHECK(SolidAngles(index, turns).winding({0, 0, 0}) == 0);
}

TEST_CASE("Half of a sphere winds half a time around its centre") {
  TriangleSoup soup;
  add_sphere(soup, {0, 0, 0}, 1, 32);
  std::erase_if(soup.triangles, [&](const auto& t) {
    return soup.points[t[0]].z + soup.points[t[1]].z + soup.points[t[2]].z < 0;
  });
  const ClosestPointIndex index(soup);
  CHECK(SolidAngles(index, {}).winding({0, 0, 0}) == doctest::Approx(0.5).epsilon(0.01));
}
