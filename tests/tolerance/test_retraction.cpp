// Where Ω is proven to shrink onto the input: as far as nothing closes, told by hand.
#include "tolerance/retraction.h"

#include "base/parallel.h"
#include "tolerance/open_shapes.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

using namespace isoscope;
using namespace isoscope::test;
using namespace isoscope::testing;

namespace {

constexpr std::size_t many = 2'000'000;

bool shrinks(const TriangleSoup& soup, double level, std::size_t most_cells = many) {
  return shrinks_onto_triangles(ClosestPointIndex(soup), level, most_cells, RunControl());
}

/// Each triangle in four.
TriangleSoup divided(const TriangleSoup& soup) {
  TriangleSoup finer;
  finer.points = soup.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] =
        middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.points.size()));
    if (fresh) finer.points.push_back(0.5 * (finer.points[a] + finer.points[b]));
    return at->second;
  };
  for (const auto& [a, b, c] : soup.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.triangles.push_back({a, ab, ca});
    finer.triangles.push_back({b, bc, ab});
    finer.triangles.push_back({c, ca, bc});
    finer.triangles.push_back({ab, bc, ca});
  }
  return finer;
}

/// A square of side 4 with a notch of some degrees from the middle of a side to its own middle.
TriangleSoup notched(double degrees) {
  const double w = 2 * std::tan(0.5 * degrees * std::numbers::pi / 180);
  TriangleSoup soup;
  soup.points = {{2, 2, 0}, {2 - w, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2 + w, 4, 0}};
  for (std::uint32_t i = 1; i < 6; ++i) soup.triangles.push_back({0, i, i + 1});
  return soup;
}

/// A strip of length 1 with walls of height 1 on both of its sides, `width` apart.
TriangleSoup channel(double width) {
  TriangleSoup soup;
  for (const double y : {0.0, 1.0})
    for (const Vec3 p : {Vec3{0, y, 1}, Vec3{0, y, 0}, Vec3{width, y, 0}, Vec3{width, y, 1}})
      soup.points.push_back(p);
  for (std::uint32_t i = 0; i < 3; ++i) {
    soup.triangles.push_back({i, i + 1, i + 5});
    soup.triangles.push_back({i, i + 5, i + 4});
  }
  return soup;
}

} // namespace

TEST_CASE("A flat square shrinks back from any tolerance, a hole closes at half of its width") {
  const TriangleSoup square = grid_sheet(6, [](double, double) { return true; });
  for (const double level : {0.05, 0.4, 2.0}) CHECK(shrinks(square, level));
  // Its hole is 0.4 wide.
  for (const double level : {0.05, 0.15, 0.19}) CHECK(shrinks(square_with_hole(), level));
  for (const double level : {0.201, 0.25}) CHECK_FALSE(shrinks(square_with_hole(), level));
}

TEST_CASE("Notches as sharp as may be close nothing") {
  for (const double degrees : {60.0, 30.0, 10.0, 3.0}) {
    CAPTURE(degrees);
    for (const double level : {0.3, 1.0}) {
      CHECK(shrinks(notched(degrees), level));
      // Small triangles along sharper ones take too many cells.
      if (degrees > 20) CHECK(shrinks(divided(divided(notched(degrees))), level));
    }
  }
}

TEST_CASE("Between walls something closes at half of what they are apart") {
  for (const TriangleSoup& soup : {channel(0.4), divided(divided(channel(0.4)))}) {
    CHECK(shrinks(soup, 0.19));
    CHECK_FALSE(shrinks(soup, 0.201));
  }
  // Crosswise triangles beside each other, which have no corner in common.
  TriangleSoup apart;
  apart.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.2}, {1, 0, 0.2}, {1, 1, 0.2}};
  apart.triangles = {{0, 1, 2}, {3, 4, 5}};
  CHECK(shrinks(apart, 0.09));
  CHECK_FALSE(shrinks(apart, 0.11));
}

TEST_CASE("A sphere shrinks back from what does not reach its centre, in triangles of any size") {
  for (const unsigned n : {4u, 16u}) {
    TriangleSoup sphere;
    add_sphere(sphere, {0, 0, 0}, 1, n);
    CAPTURE(n);
    CHECK(shrinks(sphere, 0.3));
    CHECK_FALSE(shrinks(sphere, 1.01));
  }
}

TEST_CASE("A bay with a narrow mouth closes there though it has no hole in the end") {
  // 0.4 wide and deep behind a mouth of 0.1.
  const TriangleSoup bay = grid_sheet(20, [](double x, double y) {
    return !(std::abs(x - 0.5) < 0.2 && std::abs(y - 0.6) < 0.2) && !(std::abs(x - 0.5) < 0.05 && y > 0.8);
  });
  CHECK(shrinks(bay, 0.045));
  CHECK_FALSE(shrinks(bay, 0.3));
}

TEST_CASE("What takes more cells than asked for is not proven, and threads make no difference") {
  const TriangleSoup hills = grid_sheet(
      24, [](double, double) { return true; },
      [](double x, double y) { return 0.15 * std::sin(3 * x + 1) * std::cos(4 * y); });
  for (const unsigned threads : {1u, 3u}) {
    const ThreadLimit limit(threads);
    CHECK(shrinks(hills, 0.05));
    CHECK_FALSE(shrinks(hills, 0.05, 1000));
  }
}
