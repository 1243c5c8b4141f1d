// Shortest handle loops on tori of known size; none where there is no handle.
#include "mesh/shortest_loop.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace isoscope;

namespace {

constexpr double pi = std::numbers::pi;

/// Quads around a torus with the z axis; `around` of them along the ring, `across` along the tube.
ZeroSet torus(double ring, double tube, std::uint32_t around, std::uint32_t across) {
  ZeroSet z;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * pi * i / around, b = 2 * pi * j / across, r = ring + tube * std::cos(b);
      z.vertices.push_back({{r * std::cos(a), r * std::sin(a), tube * std::sin(b)}, {}, {}});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % around) * across + j % across; };
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      ZeroSet::Polygon p;
      p.v = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      p.count = 4;
      z.polygons.push_back(p);
    }
  return z;
}

double polygon(double radius, std::uint32_t corners) {
  return 2 * radius * corners * std::sin(pi / corners);
}

} // namespace

TEST_CASE("on a thin torus the loop goes around the tube") {
  const auto loop = shortest_handle_loop(torus(3, 1, 24, 12), 0, 1000, RunControl());
  REQUIRE(loop);
  CHECK(loop->length == doctest::Approx(polygon(1, 12)));
  CHECK(loop->vertices.size() == 12);
}

TEST_CASE("on a thick torus it goes through the hole") {
  const auto loop = shortest_handle_loop(torus(1.2, 1, 16, 20), 0, 1000, RunControl());
  REQUIRE(loop);
  CHECK(loop->length == doctest::Approx(polygon(0.2, 16)));
}

TEST_CASE("few bases find a loop of a handle too, perhaps a longer one") {
  const ZeroSet z = torus(3, 1, 24, 12);
  const auto loop = shortest_handle_loop(z, 0, 2, RunControl());
  REQUIRE(loop);
  CHECK(loop->length >= polygon(1, 12) * (1 - 1e-12));
  CHECK(loop->length < 2 * polygon(1, 12));
}

TEST_CASE("nothing on a sphere, on an open surface and on another component") {
  ZeroSet tetrahedron;
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    tetrahedron.vertices.push_back({p, {}, {}});
  using Corners = std::array<std::uint32_t, 4>;
  for (const Corners v :
       {Corners{0, 2, 1, 0}, Corners{0, 1, 3, 0}, Corners{1, 2, 3, 0}, Corners{0, 3, 2, 0}}) {
    ZeroSet::Polygon p;
    p.v = v;
    tetrahedron.polygons.push_back(p);
  }
  CHECK(!shortest_handle_loop(tetrahedron, 0, 100, RunControl()));
  ZeroSet open = torus(3, 1, 24, 12);
  open.polygons.pop_back();
  CHECK(!shortest_handle_loop(open, 0, 100, RunControl()));
  CHECK(!shortest_handle_loop(torus(3, 1, 24, 12), 1, 100, RunControl()));
}
