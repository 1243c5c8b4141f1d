// Sides of the distance grid and the empty space around Ω.
#include "scene/empty_space.h"
#include "scene/quality_control.h"
#include "scene/thinning.h"

#include "input/gallery.h"
#include "scene/fabricate.h"
#include "tolerance/closest_point.h"
#include "tolerance/grid_sides.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace isoscope;

namespace {

GridWish wish_for(double delta, double voxel) {
  GridWish wish;
  wish.delta = delta;
  wish.voxel = voxel;
  return wish;
}

Vec3 position(const DistanceGrid& grid, std::size_t brick, std::size_t sample) {
  const auto i = static_cast<int>(sample), n = DistanceGrid::samples;
  return grid.corner(grid.at[brick]) + grid.voxel * Vec3{static_cast<double>(i % n),
                                                         static_cast<double>(i / n % n),
                                                         static_cast<double>(i / (n * n))};
}

} // namespace

TEST_CASE("sides of a grid are those of the surface, also where voxels are coarser than Ω") {
  const auto soup = make_gallery_model("sphere");
  REQUIRE(soup);
  const auto shared_index = std::make_shared<const ClosestPointIndex>(*soup);
  const ClosestPointIndex& index = *shared_index;
  const InputSides sides(shared_index, SideRule::parity, nullptr);
  const RunControl control;
  const double edge = soup->bounds().longest_edge();
  for (const double part : {0.03, 0.004}) {
    auto grid = make_distance_grid(index, wish_for(part * edge, 0.025 * edge), control);
    REQUIRE(grid);
    REQUIRE(find_sides(*grid, {index, sides, part * edge, {}}, control));
    CHECK(grid->has_sides);
    std::size_t wrong = 0;
    for (std::size_t b = 0; b < grid->bricks(); b += 3)
      for (std::size_t i = 0; i < DistanceGrid::brick_size; ++i) {
        const int expected = index.inside_by_parity(position(*grid, b, i)) ? -1 : 1;
        if ((grid->brick(b)[i] < 0 ? -1 : 1) != expected) ++wrong;
      }
    CHECK(wrong == 0);
    // Empty places too.
    CHECK(grid->signed_value(soup->bounds().center()) < 0);
    CHECK(grid->signed_value(grid->box.lo) > 0);
    CHECK(std::count(grid->index.begin(), grid->index.end(), DistanceGrid::inner) > 0);
  }
}

TEST_CASE("finding sides can be cancelled") {
  const auto soup = make_gallery_model("sphere");
  const auto index = std::make_shared<const ClosestPointIndex>(*soup);
  RunControl control;
  auto grid = make_distance_grid(*index, wish_for(0.05, 0.1), control);
  REQUIRE(grid);
  control.cancel();
  const Status status =
      find_sides(*grid, {*index, InputSides(index, SideRule::parity, nullptr), 0.05, {}}, control);
  REQUIRE_FALSE(status);
  CHECK(status.error().code == ErrorCode::cancelled);
}

TEST_CASE("no way through empty places passes over Ω") {
  DistanceGrid grid;
  grid.places = {30, 23, 17};
  grid.clamp = 4;
  grid.index.assign(30 * 23 * 17, DistanceGrid::outer);
  const std::vector<std::array<int, 3>> full{{{3, 20, 2}, {25, 4, 14}, {14, 12, 8}}};
  for (const auto& place : full) {
    grid.index[grid.place(place)] = static_cast<std::int32_t>(grid.at.size());
    grid.at.push_back(place);
  }
  grid.at.push_back({0, 0, 0}); // a brick without Ω
  grid.index[0] = 3;
  grid.values.assign(4 * DistanceGrid::brick_size, DistanceGrid::most);
  for (std::size_t b = 0; b < 3; ++b) grid.values[b * DistanceGrid::brick_size + 77] = DistanceGrid::most / 8;
  const std::vector<float> least = least_in_bricks(grid);
  CHECK(least[0] == doctest::Approx(0.5).epsilon(0.001));
  const auto entries = place_entries(grid, least, 1);
  std::uint32_t longest = 0;
  for (int z = 0; z < 17; ++z)
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 30; ++x) {
        int nearest = 1000;
        for (const auto& f : full)
          nearest = std::min(nearest, std::max({std::abs(x - f[0]), std::abs(y - f[1]), std::abs(z - f[2])}));
        const std::uint32_t entry = entries[grid.place({x, y, z})];
        if (nearest == 0) {
          CHECK((entry & full_place) != 0);
          continue;
        }
        CHECK(entry == static_cast<std::uint32_t>(nearest));
        longest = std::max(longest, entry);
      }
  CHECK(longest >= 8);
}

TEST_CASE("slow frames make moving coarser, quick ones finer, rest stays full") {
  QualityControl control(true);
  const double volume = control.choose(Quality::moving).volume_scale;
  for (int i = 0; i < 10; ++i) control.took(Quality::moving, 0.5);
  CHECK(control.choose(Quality::moving).scale <= 0.5);
  CHECK(control.choose(Quality::rest).scale == 1);
  CHECK(control.choose(Quality::rest).samples == 4);
  control.took(Quality::rest, 0.001);
  CHECK(control.choose(Quality::moving).scale <= 0.5);
  for (int i = 0; i < 10; ++i) control.took(Quality::moving, 0.001);
  CHECK(control.choose(Quality::moving).scale == 1);
  CHECK(control.choose(Quality::moving).volume_scale >= volume);
}

TEST_CASE("every prefix of the thinning order is spread over the surface") {
  std::vector<Vec3> positions;
  std::vector<std::int8_t> labels;
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y) {
      positions.push_back({x + 0.5, y + 0.5, 0});
      labels.push_back((x + y) % 2 == 0 ? 1 : -1);
    }
  const std::vector<std::uint32_t> order = thinning_order(positions, labels);
  REQUIRE(order.size() == positions.size());
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) CHECK(sorted[i] == i);
  // A sixteenth of them: each quarter of the square and each label has its share.
  std::set<std::pair<int, int>> cells;
  int positive = 0;
  for (std::size_t i = 0; i < order.size() / 16; ++i) {
    const Vec3 p = positions[order[i]];
    cells.insert({static_cast<int>(p.x) / 8, static_cast<int>(p.y) / 8});
    positive += labels[order[i]] > 0 ? 1 : 0;
  }
  CHECK(cells.size() >= 60); // of 64
  CHECK(positive > 96);
  CHECK(positive < 160);
  CHECK(thinning_order(positions, labels) == order);
}
