// Sides of the distance grid and the empty space around Ω.
#include "scene/brick_atlas.h"
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
#include <limits>
#include <set>
#include <string>
#include <unordered_map>

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
  // The walls of the bracket are flat and lie along the lattice.
  for (const char* model : {"sphere", "bracket"}) {
    CAPTURE(model);
    const auto soup = make_gallery_model(model);
    REQUIRE(soup);
    const auto shared_index = std::make_shared<const ClosestPointIndex>(*soup);
    const ClosestPointIndex& index = *shared_index;
    const InputSides sides(shared_index, SideRule::parity, nullptr);
    const RunControl control;
    const double edge = soup->bounds().longest_edge();
    for (const double part : {0.03, 0.004}) {
      CAPTURE(part);
      auto grid = make_distance_grid(index, wish_for(part * edge, 0.025 * edge), control);
      REQUIRE(grid);
      REQUIRE(find_sides(*grid, {index, sides, part * edge, {}}, control));
      CHECK(grid->has_sides);
      std::size_t wrong = 0, inside = 0;
      for (std::size_t b = 0; b < grid->bricks(); b += 3)
        for (std::size_t i = 0; i < DistanceGrid::brick_size; ++i) {
          const Vec3 p = position(*grid, b, i);
          // Between flat walls and a lattice along them a segment may run through an edge: what lies within
          // half a voxel of the surface is no part of a boundary of Ω.
          const double least = model == std::string("bracket") ? 0.51 * grid->voxel : 1e-6 * edge;
          if (index.distance(p) < least) continue;
          const int expected = index.inside_by_parity(p) ? -1 : 1;
          if (expected < 0) ++inside;
          if ((grid->brick(b)[i] < 0 ? -1 : 1) != expected) ++wrong;
        }
      CHECK(wrong == 0);
      CHECK(inside > 200);
      CHECK(grid->signed_value(grid->box.lo) > 0);
      if (model != std::string("sphere")) continue;
      // Empty places too.
      CHECK(grid->signed_value(soup->bounds().center()) < 0);
      CHECK(std::count(grid->index.begin(), grid->index.end(), DistanceGrid::inner) > 0);
    }
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
  grid.reach = grid.clamp = 4;
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
  int longest = 0;
  for (int z = 0; z < 17; ++z)
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 30; ++x) {
        int nearest = 1000;
        for (const auto& f : full)
          nearest = std::min(nearest, std::max({std::abs(x - f[0]), std::abs(y - f[1]), std::abs(z - f[2])}));
        const std::uint32_t entry = entries[grid.place({x, y, z})];
        CHECK(static_cast<int>(entry >> brick_bits) == nearest);
        CHECK(is_full(entry) == (nearest == 0));
        longest = std::max(longest, nearest);
      }
  // One without Ω keeps its brick: gradients beside it look there.
  CHECK((entries[0] & ((1u << brick_bits) - 1)) == BrickAtlas(grid.bricks()).packed(3));
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

TEST_CASE(
    "a resting picture is averaged from more frames where they are quick, from fewer where they are slow") {
  CHECK(resting_frames(8, 0.004) == 32);
  CHECK(resting_frames(8, 0.1) == 8);
  CHECK(resting_frames(8, 0.5) == 4);
  CHECK(resting_frames(8, 5) == 1);
  CHECK(resting_frames(1, 0.1) == 1);
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

namespace {

/// A texture that bricks were uploaded to.
class Uploaded {
 public:
  explicit Uploaded(const DistanceGrid& grid) : grid_(grid), atlas_(grid.bricks()) {
    for (std::size_t b = 0; b < atlas_.count(); ++b) bricks_[atlas_.packed(b)] = b;
  }
  std::array<int, 3> size() const { return atlas_.size(); }
  double sample(std::array<int, 3> at) const {
    constexpr int n = DistanceGrid::samples;
    const auto found = bricks_.find(static_cast<std::uint32_t>(at[0] / n | at[1] / n << 8 | at[2] / n << 16));
    if (found == bricks_.end()) return std::numeric_limits<double>::quiet_NaN();
    const std::size_t brick = found->second;
    if (brick >= grid_.bricks())
      return static_cast<double>(brick == atlas_.outer() ? grid_.reach : -grid_.reach);
    return static_cast<double>(grid_.clamp) / DistanceGrid::most *
           grid_.brick(brick)[DistanceGrid::sample(at[0] % n, at[1] % n, at[2] % n)];
  }

 private:
  const DistanceGrid& grid_;
  BrickAtlas atlas_;
  std::unordered_map<std::uint32_t, std::size_t> bricks_;
};

/// What shaders/bricks.glsl reads, in its precision.
double read_as_shaders_do(const DistanceGrid& grid, const Uploaded& texture,
                          const std::vector<std::uint32_t>& entries, Vec3 p) {
  const auto size = texture.size();
  const auto side = static_cast<float>(DistanceGrid::cells * grid.voxel);
  std::array<float, 3> part{};
  std::array<int, 3> place{};
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    const float q = static_cast<float>(p[a] - grid.box.lo[a]) / side;
    const float cell = std::clamp(std::floor(q), 0.0f, static_cast<float>(grid.places[k] - 1));
    place[k] = static_cast<int>(cell);
    part[k] = std::clamp(q - cell, 0.0f, 1.0f);
  }
  const std::uint32_t entry = entries[grid.place(place)];
  const std::array<std::uint32_t, 3> brick{entry & 255u, entry >> 8 & 255u, entry >> 16 & 255u};
  std::array<int, 3> low{};
  std::array<double, 3> weight{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float at =
        (8.0f * static_cast<float>(brick[k]) + 0.5f + 7.0f * part[k]) * (1.0f / static_cast<float>(size[k]));
    const double x = static_cast<double>(at * static_cast<float>(size[k])) - 0.5;
    low[k] = static_cast<int>(std::floor(x));
    weight[k] = x - low[k];
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    double w = 1;
    std::array<int, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int up = c >> k & 1;
      w *= up ? weight[k] : 1 - weight[k];
      at[k] = std::clamp(low[k] + up, 0, size[k] - 1);
    }
    if (w > 0) sum += w * texture.sample(at);
  }
  return sum;
}

} // namespace

TEST_CASE("what is read through the bricks is the same everywhere in Ω, also where two of them meet") {
  // Creases, flat walls and round ones.
  const auto soup = make_gallery_model("bracket");
  REQUIRE(soup);
  const ClosestPointIndex index(*soup);
  const double edge = soup->bounds().longest_edge(), delta = 0.02 * edge;
  const RunControl control;
  for (const double across : {4.0, 7.3}) {
    const auto grid = make_distance_grid(index, wish_for(delta, 2 * delta / across), control);
    REQUIRE(grid);
    const auto entries = place_entries(*grid, least_in_bricks(*grid), 1);
    const double unit = static_cast<double>(grid->clamp) / DistanceGrid::most;
    const double side = DistanceGrid::cells * grid->voxel;
    const Uploaded texture(*grid);
    // φ/δ between the corners of the cell that holds a point, without bricks.
    const auto direct = [&](Vec3 p) {
      Vec3 low;
      std::array<double, 3> part{};
      for (int a = 0; a < 3; ++a) {
        const double x = (p[a] - grid->box.lo[a]) / grid->voxel;
        low[a] = grid->box.lo[a] + grid->voxel * std::floor(x);
        part[static_cast<std::size_t>(a)] = x - std::floor(x);
      }
      double sum = 0;
      for (int c = 0; c < 8; ++c) {
        const Vec3 corner =
            low + grid->voxel * Vec3{(c & 1) ? 1.0 : 0.0, (c & 2) ? 1.0 : 0.0, (c & 4) ? 1.0 : 0.0};
        sum += ((c & 1) ? part[0] : 1 - part[0]) * ((c & 2) ? part[1] : 1 - part[1]) *
               ((c & 4) ? part[2] : 1 - part[2]) * index.distance(corner);
      }
      return sum / delta;
    };
    const auto entry_of = [&](Vec3 p) {
      std::array<int, 3> place{};
      for (int a = 0; a < 3; ++a)
        place[static_cast<std::size_t>(a)] = static_cast<int>(std::floor((p[a] - grid->box.lo[a]) / side));
      return std::pair{grid->index[grid->place(place)], entries[grid->place(place)]};
    };
    std::size_t seen = 0, at_borders = 0, wrong = 0, shaders_wrong = 0, not_looked_at = 0, without_brick = 0;
    for (int i = 0; seen < 1500 && i < 200000; ++i) {
      const auto part = [&](int k) {
        constexpr std::array<double, 3> steps{0.8191725134, 0.6710436067, 0.5497004779};
        return std::fmod(0.5 + i * steps[static_cast<std::size_t>(k)], 1.0);
      };
      Vec3 p = grid->box.lo;
      // Every second point lies on one, two or three borders, or as near as numbers tell apart.
      const int snapped = i % 2 == 0 ? 0 : i / 2 % 7 + 1;
      for (int a = 0; a < 3; ++a) {
        p[a] += part(a) * grid->box.extent()[a];
        if ((snapped >> a & 1) == 0) continue;
        const double border = grid->box.lo[a] + side * std::floor((p[a] - grid->box.lo[a]) / side);
        p[a] = i / 14 % 3 == 0   ? border
               : i / 14 % 3 == 1 ? std::nextafter(border, -1e300)
                                 : std::nextafter(border, 1e300);
        p[a] = std::max(p[a], grid->box.lo[a]);
      }
      const double value = direct(p);
      if (value > 1) continue;
      ++seen;
      if (snapped != 0) ++at_borders;
      if (std::abs(grid->value(p) - value) > 1.01 * unit) ++wrong;
      // Single precision moves a point by a little of a cell.
      if (std::abs(read_as_shaders_do(*grid, texture, entries, p) - value) > 2 * unit + 2e-4) ++shaders_wrong;
      if (!is_full(entry_of(p).second)) ++not_looked_at;
      // Gradients look this far.
      for (int c = 0; c < 8; ++c)
        if (entry_of(p + 0.9 * grid->voxel *
                             Vec3{(c & 1) ? 1.0 : -1.0, (c & 2) ? 1.0 : -1.0, (c & 4) ? 1.0 : -1.0})
                .first < 0)
          ++without_brick;
    }
    CAPTURE(across);
    CHECK(seen == 1500);
    CHECK(at_borders > 400);
    CHECK(wrong == 0);
    CHECK(shaders_wrong == 0);
    CHECK(not_looked_at == 0);
    CHECK(without_brick == 0);
  }
}

TEST_CASE("bricks have room in a texture and each a place of its own") {
  const BrickAtlas atlas(DistanceGrid::most_bricks);
  for (const int side : atlas.size()) CHECK(side <= 2048); // of any driver
  std::vector<std::uint32_t> places;
  for (std::size_t b = 0; b < atlas.count(); ++b) {
    places.push_back(atlas.packed(b));
    if (atlas.at(b)[0] > 255 || places.back() >> brick_bits != 0) FAIL_CHECK("beyond the bits");
  }
  std::sort(places.begin(), places.end());
  CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
  CHECK(BrickAtlas(3).size() == std::array{8, 40, 8});
  std::size_t runs = 0;
  for (std::size_t b = 0; b < BrickAtlas(1000).count(); b += BrickAtlas(1000).run(b)) ++runs;
  CHECK(runs == 4);
}
