// Bricks are uploaded a column of them at a time.
#include "scene/brick_texture.h"

#include "scene/brick_atlas.h"
#include "scene/empty_space.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

constexpr int n = DistanceGrid::samples;

/// Fills a texture from what the samples give.
template <class Value, class Of>
void upload(gl::Texture& texture, const DistanceGrid& grid, const BrickAtlas& atlas, const Of& of) {
  constexpr std::size_t slice = std::size_t{n} * n;
  // What has no brick is at least this far away.
  const double most = DistanceGrid::most, part = static_cast<double>(grid.reach / grid.clamp);
  const auto beyond = static_cast<std::int16_t>(std::floor(most * part));
  std::vector<Value> column;
  for (std::size_t first = 0; first < atlas.count(); first += atlas.run(first)) {
    const std::size_t count = atlas.run(first);
    column.resize(count * DistanceGrid::brick_size);
    for (std::size_t b = 0; b < count; ++b) {
      const std::size_t brick = first + b;
      for (std::size_t i = 0; i < DistanceGrid::brick_size; ++i) {
        const std::int16_t value = brick < grid.bricks()    ? grid.brick(brick)[i]
                                   : brick == atlas.outer() ? beyond
                                                            : static_cast<std::int16_t>(-beyond);
        column[(i / slice * count + b) * slice + i % slice] = of(value);
      }
    }
    const std::array<int, 3> at = atlas.at(first);
    texture.fill_volume({n * at[0], n * at[1], n * at[2]}, {n, n * static_cast<int>(count), n},
                        std::span<const Value>(column));
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
  const BrickAtlas atlas(grid_->bricks());
  const std::array<int, 3> size = atlas.size(), one{1, 1, 1};
  atlas_size_ = {size[0], size[1], size[2]};
  largest_ = grid_->sample_bytes == 1 ? grid_->reach : grid_->clamp;
  if (grid_->sample_bytes == 1) {
    bricks_.allocate_volume(size, gl::Format::r8s, true);
    const float steps = 127 * grid_->clamp / (grid_->reach * DistanceGrid::most);
    upload<std::int8_t>(bricks_, *grid_, atlas, [&](std::int16_t v) {
      const float step = std::clamp(std::round(steps * static_cast<float>(v)), -127.0f, 127.0f);
      return static_cast<std::int8_t>(signed_ ? step : std::abs(step));
    });
  } else {
    bricks_.allocate_volume(size, gl::Format::r16s, true);
    upload<std::int16_t>(bricks_, *grid_, atlas, [&](std::int16_t v) {
      return signed_ ? v : static_cast<std::int16_t>(std::abs(v));
    });
  }
  sides_.allocate_volume(signed_ ? one : size, gl::Format::r8s, true);
  if (signed_)
    sides_.fill_volume({0, 0, 0}, one, std::array<std::int8_t, 1>{127});
  else
    upload<std::int8_t>(sides_, *grid_, atlas,
                        [](std::int16_t v) { return static_cast<std::int8_t>(v < 0 ? -127 : 127); });
}

void BrickTexture::prepare(float level) {
  if (entries_level_ == level) return;
  entries_level_ = level;
  places_.allocate_volume(grid_->places, gl::Format::r32u, false);
  places_.fill_volume({0, 0, 0}, grid_->places, place_entries(*grid_, least_, level));
}

void BrickTexture::set_uniforms(gl::Program& program, const SceneSpace& space, int first_unit,
                                const std::string& prefix) {
  const auto set = [&](const char* name, const auto& value) { program.set((prefix + name).c_str(), value); };
  bricks_.bind(first_unit);
  sides_.bind(first_unit + 1);
  places_.bind(first_unit + 2);
  set("bricks", first_unit);
  set("brick_sides", first_unit + 1);
  set("places", first_unit + 2);
  set("is_signed", signed_ ? 1 : 0);
  set("largest_value", largest_);
  set("box_lo", space.local(grid_->box.lo));
  set("box_hi", space.local(grid_->box.hi));
  set("place_side", static_cast<float>(DistanceGrid::cells * grid_->voxel));
  set("place_count", glm::vec3(grid_->places[0], grid_->places[1], grid_->places[2]));
  set("atlas_unit", 1.0f / atlas_size_);
}

} // namespace isoscope
