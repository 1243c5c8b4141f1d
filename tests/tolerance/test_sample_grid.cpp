// What the grid gathers are the points of the cells that a box meets, each once.
#include "tolerance/sample_grid.h"

#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using isoscope::testing::Random;

TEST_CASE("points are gathered from the cells that meet a box, while the grid grows") {
  constexpr double side = 0.1;
  const Vec3 origin{-1, -2, -3};
  Random random(3);
  SampleGrid grid(origin, side);
  std::vector<Vec3> points;
  std::vector<std::uint32_t> found, expected;
  const auto cell = [&](double x, double least) { return std::floor((x - least) / side); };
  for (int round = 0; round < 40; ++round) {
    for (int i = 0; i < 250; ++i) {
      points.push_back(random.in_box({{-1.5, -2.5, -3.5}, {0.5, 0, 1}}));
      if (i % 10 == 0) points.push_back(points.back()); // places that occur twice
    }
    for (std::size_t i = points.size() - 275; i < points.size(); ++i) grid.add(points[i]);
    const Vec3 p = points[random.below(points.size())];
    const Box3 box = Box3{p, p}.grown(random.between(0, 0.3));
    found.clear();
    expected.clear();
    grid.gather(box, found);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      bool within = true;
      for (int a = 0; a < 3; ++a) {
        const double at = cell(points[i][a], origin[a]);
        within = within && at >= cell(box.lo[a], origin[a]) && at <= cell(box.hi[a], origin[a]);
      }
      if (within) expected.push_back(i);
    }
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
  }
  CHECK(grid.memory_bytes() < 40 * points.size());
}
