// Ω: ray marching of the distance grid, its boundaries as tinted translucent surfaces.
#include "scene/layer_tolerance.h"

#include "base/parallel.h"

#include <glad/gl.h>

#include <algorithm>

namespace isoscope {

namespace {

/// Of the blocks that a ray may cross at once, in voxels.
constexpr int block_side = 8;

} // namespace

void ToleranceLayer::set(const DistanceGrid& grid, double delta, bool meets_zero) {
  present_ = !grid.values.empty() && delta > 0;
  if (!present_) return;
  box_ = grid.box;
  delta_ = delta;
  const Vec3 extent = grid.box.extent();
  voxel_ = {extent.x / grid.size[0], extent.y / grid.size[1], extent.z / grid.size[2]};
  signed_ = meets_zero || grid.sides.empty();
  const auto by_side = [&](auto&& value) {
    std::vector<float> values(grid.values.size());
    parallel_for(values.size(), 1u << 16,
                 [&](std::size_t i) { values[i] = grid.sides[i] > 0 ? value(i) : -value(i); });
    return values;
  };
  if (grid.sides.empty() || !signed_)
    grid_.upload_volume(grid.size, grid.values, gl::Format::r16f, true);
  else
    grid_.upload_volume(grid.size, by_side([&](std::size_t i) { return grid.values[i]; }), gl::Format::r16f,
                        true);
  if (signed_)
    sides_.upload_volume({1, 1, 1}, std::array{1.0f}, gl::Format::r16f, true);
  else
    sides_.upload_volume(grid.size, by_side([](std::size_t) { return 1.0f; }), gl::Format::r16f, true);
  blocks_ = grid_blocks(grid, block_side);
  skip_level_ = 0;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    skip_scale_[i] = static_cast<float>(grid.size[k]) / static_cast<float>(block_side * blocks_.size[k]);
  }
}

void ToleranceLayer::set_common(gl::Program& program, const ViewFrame& frame) {
  program.use();
  grid_.bind(0);
  sides_.bind(3);
  program.set("grid", 0);
  program.set("sides", 3);
  program.set("is_signed", signed_ ? 1 : 0);
  program.set("level", frame.view.level);
  program.set("box_lo", frame.space.local(box_.lo));
  program.set("box_hi", frame.space.local(box_.hi));
  program.set("delta", static_cast<float>(delta_));
  const auto opacity = [](const LayerSettings& layer) { return layer.shown() ? layer.opacity : 0.0f; };
  program.set("outer_tint", glm::vec4(frame.colors.outer, opacity(frame.view.outer)));
  program.set("inner_tint", glm::vec4(frame.colors.inner, opacity(frame.view.inner)));
}

void ToleranceLayer::march(gl::Program& program, const ViewFrame& frame, const gl::Texture& scene_depth,
                           float coarseness) {
  if (skip_level_ != frame.view.level) {
    skip_level_ = frame.view.level;
    const auto smallest = static_cast<double>(std::min({voxel_.x, voxel_.y, voxel_.z}));
    skip_.upload_volume(blocks_.size, empty_space(blocks_, skip_level_, smallest), gl::Format::r32f, false);
  }
  set_common(program, frame);
  skip_.bind(1);
  scene_depth.bind(2);
  program.set("skip", 1);
  program.set("scene_depth", 2);
  program.set("skip_scale", skip_scale_);
  program.set("voxel", voxel_);
  program.set("max_steps", coarseness > 1 ? 96 : 400);
  program.set("coarseness", coarseness);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ToleranceLayer::prepare_section(gl::Program& program, const ViewFrame& frame) {
  set_common(program, frame);
}

} // namespace isoscope
