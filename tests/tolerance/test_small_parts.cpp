// The distance grid and the check of parameters.
#include "tolerance/closest_point.h"
#include "tolerance/distance_grid.h"
#include "tolerance/parameter_check.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("the distance grid is exact below its clamp and clamped beyond") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.3, 24);
  const ClosestPointIndex index(soup);
  const double delta = 0.05;
  const auto grid = make_distance_grid(index, delta, 37, RunControl());
  REQUIRE(grid.ok());
  CHECK(std::max({grid->size[0], grid->size[1], grid->size[2]}) == 37);
  REQUIRE(grid->values.size() == static_cast<std::size_t>(grid->size[0] * grid->size[1] * grid->size[2]));
  const Vec3 extent = grid->box.extent();
  std::size_t i = 0, wrong = 0;
  for (int z = 0; z < grid->size[2]; ++z)
    for (int y = 0; y < grid->size[1]; ++y)
      for (int x = 0; x < grid->size[0]; ++x, ++i) {
        const Vec3 p =
            grid->box.lo + Vec3{extent.x * (x + 0.5) / grid->size[0], extent.y * (y + 0.5) / grid->size[1],
                                extent.z * (z + 0.5) / grid->size[2]};
        const double expected = std::min(index.distance(p) / delta, static_cast<double>(grid->clamp));
        if (std::abs(static_cast<double>(grid->values[i]) - expected) > 1e-5) ++wrong;
      }
  CHECK(wrong == 0);
  CHECK(make_distance_grid(index, 0, 10, RunControl()).error().code == ErrorCode::usage);
}

TEST_CASE("parameters that cannot satisfy condition 2 or section 3 are warned about") {
  CHECK(check_parameters(0.1, 0.2, 1, true).empty());
  CHECK(check_parameters(0.2, 0.2, 1, true).empty());
  CHECK(check_parameters(0.5, 0.2, 1, false).empty());
  const auto one = check_parameters(0.5, 0.2, 1, true);
  REQUIRE(one.size() == 1);
  CHECK(one[0].largest_sigma == doctest::Approx(0.2));
  CHECK(one[0].message.find("condition 2") != std::string::npos);
  CHECK(check_parameters(1.0, 0.2, 1, false).size() == 1);
  CHECK(check_parameters(2.0, 0.2, 1, true).size() == 2);
}

TEST_CASE("the density in use follows the number of samples it makes") {
  CHECK(default_sigma_ratio(1, 0.01) == 0.5);
  const double area = 6, delta = 0.004;
  const double ratio = default_sigma_ratio(area, delta);
  CHECK(ratio > 0.5);
  CHECK(ratio < 0.95);
  CHECK(3 * area / (ratio * ratio * delta * delta) == doctest::Approx(2e6));
  CHECK(default_sigma_ratio(2 * area, delta) > ratio);
  CHECK(default_sigma_ratio(area, 1e-6) == 0.95);
}
