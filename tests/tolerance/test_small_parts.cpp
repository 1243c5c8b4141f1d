// The distance grid and the check of parameters.
#include "base/parallel.h"
#include "tolerance/closest_point.h"
#include "tolerance/distance_grid.h"
#include "tolerance/parameter_check.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;

namespace {

TriangleSoup torus() {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.3, 24);
  return soup;
}

} // namespace

TEST_CASE("the distance grid is exact where it has samples, and has them all around Ω") {
  const ClosestPointIndex index(torus());
  GridWish wish;
  wish.delta = 0.05;
  wish.voxel = 0.03;
  const auto grid = make_distance_grid(index, wish, RunControl());
  REQUIRE(grid.ok());
  CHECK_FALSE(grid->coarsened);
  CHECK(grid->bricks() * DistanceGrid::brick_size == grid->values.size());
  const double unit = static_cast<double>(grid->clamp) / DistanceGrid::most;
  std::size_t wrong = 0;
  for (std::size_t b = 0; b < grid->bricks(); ++b)
    for (int z = 0; z < DistanceGrid::samples; ++z)
      for (int y = 0; y < DistanceGrid::samples; ++y)
        for (int x = 0; x < DistanceGrid::samples; ++x) {
          const Vec3 p =
              grid->corner(grid->at[b]) +
              grid->voxel * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          const double expected =
              std::clamp(index.distance(p) / wish.delta, unit, static_cast<double>(grid->clamp));
          if (std::abs(unit * grid->brick(b)[DistanceGrid::sample(x, y, z)] - expected) > unit) ++wrong;
        }
  CHECK(wrong == 0);
  // Whoever looks at a point in Ω finds its value; far from it there is nothing.
  std::size_t missing = 0, empty = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 e = grid->box.extent();
    const Vec3 p = grid->box.lo + Vec3{e.x * std::fmod(0.5 + i * 0.8191725134, 1.0),
                                       e.y * std::fmod(0.5 + i * 0.6710436067, 1.0),
                                       e.z * std::fmod(0.5 + i * 0.5497004779, 1.0)};
    const double d = index.distance(p) / wish.delta;
    if (d < 1.2 && std::abs(grid->value(p) - d) > 0.35) ++missing;
    if (grid->value(p) == static_cast<double>(grid->reach)) ++empty;
  }
  CHECK(missing == 0);
  CHECK(empty > 1000);
  wish.delta = 0;
  CHECK(make_distance_grid(index, wish, RunControl()).error().code == ErrorCode::usage);
}

TEST_CASE("a grid that memory does not allow is as fine as it may be and says so") {
  const ClosestPointIndex index(torus());
  GridWish wish;
  wish.delta = 0.01;
  wish.voxel = wish.coarsest = 0.005;
  wish.most_bytes = std::size_t{3} << 20;
  const auto grid = make_distance_grid(index, wish, RunControl());
  REQUIRE(grid.ok());
  CHECK(grid->coarsened);
  CHECK(grid->texture_bytes() <= wish.most_bytes);
  CHECK(grid->texture_bytes() > wish.most_bytes / 2);
  CHECK(grid->voxel > wish.voxel);
  // The same however many threads there are.
  const ThreadLimit one(1);
  const auto again = make_distance_grid(index, wish, RunControl());
  REQUIRE(again.ok());
  CHECK(again->index == grid->index);
  CHECK(again->values == grid->values);
}

TEST_CASE("samples take one byte before voxels grow") {
  const ClosestPointIndex index(torus());
  GridWish wish;
  wish.delta = 0.04;
  wish.voxel = wish.coarsest = 0.02;
  const auto whole = make_distance_grid(index, wish, RunControl());
  REQUIRE(whole.ok());
  CHECK(whole->sample_bytes == 2);
  wish.most_bytes = 3 * whole->texture_bytes() / 4;
  const auto tight = make_distance_grid(index, wish, RunControl());
  REQUIRE(tight.ok());
  CHECK(tight->sample_bytes == 1);
  CHECK(tight->voxel == whole->voxel);
  CHECK_FALSE(tight->coarsened);
  CHECK(tight->values == whole->values);
  CHECK(tight->texture_bytes() <= wish.most_bytes);
  // A side of its own is a byte more.
  wish.side_bytes = 1;
  const auto sided = make_distance_grid(index, wish, RunControl());
  REQUIRE(sided.ok());
  CHECK(sided->coarsened);
  CHECK(sided->texture_bytes() <= wish.most_bytes);
}

TEST_CASE("a grid of a part holds that part alone, as exactly") {
  const ClosestPointIndex index(torus());
  GridWish wish;
  wish.delta = 0.04;
  wish.voxel = 0.005;
  wish.within = Box3{{0.9, -0.1, 0.2}, {1.1, 0.1, 0.4}};
  const auto part = make_distance_grid(index, wish, RunControl());
  REQUIRE(part.ok());
  CHECK(part->box.longest_edge() < 0.2 + 7 * 0.005 + 1e-9);
  std::size_t inside = 0;
  for (double x = 0.905; x < 1.1; x += 0.01)
    for (double y = -0.095; y < 0.1; y += 0.01)
      for (double z = 0.205; z < 0.4; z += 0.01) {
        const double d = index.distance({x, y, z});
        if (d > wish.delta || d < 2 * wish.voxel) continue; // no kink within a cell
        ++inside;
        CHECK(std::abs(part->value({x, y, z}) * wish.delta - d) < 0.2 * wish.voxel);
      }
  CHECK(inside > 1000);
  wish.within = Box3{{5, 5, 5}, {6, 6, 6}};
  const auto nothing = make_distance_grid(index, wish, RunControl());
  REQUIRE(nothing.ok());
  CHECK(nothing->empty());
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
