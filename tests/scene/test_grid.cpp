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

TEST_CASE("sides of a grid are those of the surface, also where voxels are coarser than Ω") {
  const auto soup = make_gallery_model("sphere");
  REQUIRE(soup);
  const auto shared_index = std::make_shared<const ClosestPointIndex>(*soup);
  const ClosestPointIndex& index = *shared_index;
  const InputSides sides(shared_index, SideRule::parity, nullptr);
  const RunControl control;
  const double edge = soup->bounds().longest_edge();
  for (const double part : {0.03, 0.004}) {
    auto grid = make_distance_grid(index, part * edge, 40, control);
    REQUIRE(grid);
    REQUIRE(find_sides(*grid, index, sides, part * edge, {}, control));
    REQUIRE(grid->sides.size() == grid->values.size());
    std::size_t wrong = 0;
    for (int z = 0; z < grid->size[2]; z += 3)
      for (int y = 0; y < grid->size[1]; y += 3)
        for (int x = 0; x < grid->size[0]; ++x) {
          const Vec3 e = grid->box.extent();
          const Vec3 p = grid->box.lo + Vec3{(x + 0.5) * e.x / grid->size[0], (y + 0.5) * e.y / grid->size[1],
                                             (z + 0.5) * e.z / grid->size[2]};
          const auto i = (static_cast<std::size_t>(z) * static_cast<std::size_t>(grid->size[1]) +
                          static_cast<std::size_t>(y)) *
                             static_cast<std::size_t>(grid->size[0]) +
                         static_cast<std::size_t>(x);
          const int expected = index.inside_by_parity(p) ? -1 : 1;
          if (grid->sides[i] != expected) ++wrong;
        }
    CHECK(wrong == 0);
  }
}

TEST_CASE("finding sides can be cancelled") {
  const auto soup = make_gallery_model("sphere");
  const auto index = std::make_shared<const ClosestPointIndex>(*soup);
  RunControl control;
  auto grid = make_distance_grid(*index, 0.05, 24, control);
  REQUIRE(grid);
  control.cancel();
  const Status status =
      find_sides(*grid, *index, InputSides(index, SideRule::parity, nullptr), 0.05, {}, control);
  REQUIRE_FALSE(status);
  CHECK(status.error().code == ErrorCode::cancelled);
}

TEST_CASE("no jump through empty space passes over Ω") {
  DistanceGrid grid;
  grid.size = {40, 33, 25};
  grid.box.add(Vec3{0, 0, 0});
  grid.box.add(Vec3{40, 33, 25});
  grid.values.assign(40 * 33 * 25, 4.0f);
  const auto voxel = [](int x, int y, int z) { return static_cast<std::size_t>((z * 33 + y) * 40 + x); };
  const std::array<std::array<int, 3>, 3> full{{{3, 30, 2}, {35, 4, 20}, {20, 20, 12}}};
  for (const auto& f : full) grid.values[voxel(f[0], f[1], f[2])] = 0.5f;
  const GridBlocks blocks = grid_blocks(grid, 8);
  const std::array<int, 3>& size = blocks.size;
  const std::vector<float> jump = empty_space(blocks, 1, 1.0);
  CHECK(size == std::array<int, 3>{5, 5, 4});
  float longest = 0;
  for (int z = 0; z < 25; ++z)
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 40; ++x) {
        const float j = jump[static_cast<std::size_t>(((z / 8) * size[1] + y / 8) * size[0] + x / 8)];
        longest = std::max(longest, j);
        for (const auto& f : full) CHECK(std::hypot(x - f[0], y - f[1], z - f[2]) >= static_cast<double>(j));
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
