// Curves of Z on states made by hand: a border where it was cut, triple curves and the point where four meet.
#include "mesh/zero_curves.h"

#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace isoscope;

TEST_CASE("the border of a patch is one closed curve, and what was cut off goes on beyond it") {
  const Complex patch = test::lattice_with_sides(
      7, [](Vec3 p) { return p.z < 3 ? -1 : 1; },
      [](Vec3 p) {
        return distance(p, Vec3{3, 3, 3}) > 1.9;
      });
  const ZeroSet zero = extract_zero_set(patch);
  const ZeroCurves curves = zero_curves(zero);
  CHECK(curves.triple.empty());
  CHECK(curves.points.empty());
  REQUIRE(curves.border.size() >= 8);
  // As its polygons run, each vertex is the beginning of one edge and the end of one.
  std::map<std::uint32_t, int> balance;
  for (const auto& [from, to] : curves.border) ++balance[from], --balance[to];
  for (const auto& [vertex, sum] : balance) CHECK(sum == 0);
  CHECK(balance.size() == curves.border.size());

  const auto dropped = dropped_facets(patch);
  REQUIRE_FALSE(dropped.empty());
  for (const DroppedFacet& f : dropped) {
    CHECK(patch.tet(f.tet).side == 1);
    CHECK(patch.tet(patch.tet(f.tet).neighbor[f.facet]).side == -1);
    CHECK_FALSE(patch.on_zero_set(f.tet, f.facet));
  }
}

TEST_CASE("rooms: a triple curve where three meet, a point where four do") {
  const auto never = [](Vec3) { return false; };
  const Complex two = test::lattice_with_sides(
      5, [](Vec3 p) { return p.z > 2 ? 1 : (p.x < 2 ? -1 : -2); }, never);
  const ZeroSet zero_of_two = extract_zero_set(two);
  const ZeroCurves line = zero_curves(zero_of_two);
  const auto at_edge = [&](std::uint32_t v) {
    const Vec3 p = zero_of_two.vertices[v].position;
    return p.x == 2 && p.z == 2;
  };
  const auto steps = std::count_if(line.triple.begin(), line.triple.end(),
                                   [&](const auto& e) { return at_edge(e[0]) && at_edge(e[1]); });
  CHECK(steps == 4);

  const Complex four = test::lattice_with_sides(
      5, [](Vec3 p) { return p.z > 2   ? 1
                             : p.x < 2 ? -1
                             : p.y < 2 ? -2
                                       : -3; }, never);
  const ZeroSet zero_of_four = extract_zero_set(four);
  const ZeroCurves curves = zero_curves(zero_of_four);
  std::size_t inner = 0;
  for (const std::uint32_t v : curves.points) inner += zero_of_four.vertices[v].position == Vec3{2, 2, 2};
  CHECK(inner == 1);
}

TEST_CASE("a closed surface has none") {
  const Complex ball = test::lattice_with_sides(
      7,
      [](Vec3 p) {
        return distance(p, Vec3{3, 3, 3}) < 2 ? -1 : 1;
      },
      [](Vec3) { return false; });
  CHECK(zero_curves(extract_zero_set(ball)).empty());
  CHECK(zero_curves(extract_zero_set(ball)).points.empty());
  CHECK(dropped_facets(ball).empty());
}
