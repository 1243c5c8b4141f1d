// Bricks are uploaded a row of them at a time.
#include "scene/brick_texture.h"

#include "scene/empty_space.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// Bricks along x and y of the texture; shaders/bricks.glsl takes a brick's number apart by them.
constexpr int row_bricks = 128, column_bricks = 128;
constexpr int n = DistanceGrid::samples;

/// The texture that holds so many bricks.
std::array<int, 3> atlas_size(std::size_t bricks) {
  const int count = std::max(static_cast<int>(bricks), 1);
  const int rows = (count + row_bricks - 1) / row_bricks;
  return {n * std::min(count, row_bricks), n * std::min(rows, column_bricks),
          n * ((rows + column_bricks - 1) / column_bricks)};
}

/// Fills a texture from what the samples give.
template <class Value, class Of>
void upload(gl::Texture& texture, const DistanceGrid& grid, std::array<int, 3> size, const Of& of) {
  std::vector<Value> row;
  for (std::size_t first = 0; first < grid.bricks(); first += row_bricks) {
    const std::size_t count = std::min<std::size_t>(row_bricks, grid.bricks() - first);
    const auto width = static_cast<std::size_t>(size[0]);
    row.assign(width * n * n, Value{});
    for (std::size_t b = 0; b < count; ++b) {
      const auto values = grid.brick(first + b);
      for (std::size_t i = 0; i < values.size(); ++i) row[i / n * width + b * n + i % n] = of(values[i]);
    }
    const auto line = static_cast<int>(first / row_bricks);
    texture.fill_volume({0, n * (line % column_bricks), n * (line / column_bricks)}, {size[0], n, n},
                        std::span<const Value>(row));
  }
}

} // namespace

void BrickTexture::clear() {
  *this = {};
}

void BrickTexture::set(std::shared_ptr<const DistanceGrid> grid, bool meets_zero) {
  clear();
  if (!grid || grid->empty()) return;
  grid_ = std::move(grid);
  signed_ = meets_zero || !grid_->has_sides;
  least_ = least_in_bricks(*grid_);
  atlas_ = atlas_size(grid_->bricks());
  bricks_.allocate_volume(atlas_, gl::Format::r16s, true);
  upload<std::int16_t>(bricks_, *grid_, atlas_,
                       [&](std::int16_t v) { return signed_ ? v : static_cast<std::int16_t>(std::abs(v)); });
  const std::array<int, 3> one{1, 1, 1};
  sides_.allocate_volume(signed_ ? one : atlas_, gl::Format::r8s, true);
  if (signed_)
    sides_.fill_volume({0, 0, 0}, one, std::array<std::int8_t, 1>{127});
  else
    upload<std::int8_t>(sides_, *grid_, atlas_,
                        [](std::int16_t v) { return static_cast<std::int8_t>(v < 0 ? -127 : 127); });
}

void BrickTexture::set_uniforms(gl::Program& program, const SceneSpace& space, float level) {
  if (entries_level_ != level) {
    entries_level_ = level;
    places_.allocate_volume(grid_->places, gl::Format::r32u, false);
    places_.fill_volume({0, 0, 0}, grid_->places, place_entries(*grid_, least_, level));
  }
  bricks_.bind(0);
  sides_.bind(1);
  places_.bind(2);
  program.set("bricks", 0);
  program.set("brick_sides", 1);
  program.set("places", 2);
  program.set("is_signed", signed_ ? 1 : 0);
  program.set("largest_value", grid_->clamp);
  program.set("box_lo", space.local(grid_->box.lo));
  program.set("box_hi", space.local(grid_->box.hi));
  program.set("place_side", static_cast<float>(DistanceGrid::cells * grid_->voxel));
  program.set("place_count", glm::vec3(grid_->places[0], grid_->places[1], grid_->places[2]));
  program.set("atlas_size", glm::vec3(atlas_[0], atlas_[1], atlas_[2]));
}

} // namespace isoscope
