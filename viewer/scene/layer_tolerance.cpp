// Ω: ray marching of the distance grid, its boundaries as tinted translucent surfaces.
#include "scene/layer_tolerance.h"

#include "base/parallel.h"
#include "scene/empty_space.h"

#include <glad/gl.h>

#include <algorithm>

namespace isoscope {

void ToleranceLayer::set(const DistanceGrid& grid, double delta) {
  present_ = !grid.values.empty() && delta > 0;
  if (!present_) return;
  box_ = grid.box;
  delta_ = delta;
  const Vec3 extent = grid.box.extent();
  voxel_ = {extent.x / grid.size[0], extent.y / grid.size[1], extent.z / grid.size[2]};
  if (grid.sides.empty()) {
    grid_.upload_volume(grid.size, grid.values, gl::Format::r16f, true);
  } else {
    std::vector<float> sided(grid.values.size());
    parallel_for(sided.size(), 1u << 16,
                 [&](std::size_t i) { sided[i] = grid.sides[i] > 0 ? grid.values[i] : -grid.values[i]; });
    grid_.upload_volume(grid.size, sided, gl::Format::r16f, true);
  }
  constexpr int block = 8;
  std::array<int, 3> size{};
  const double smallest = std::min({voxel_.x, voxel_.y, voxel_.z});
  std::vector<float> jump = empty_space(grid, block, smallest, size);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    skip_scale_[i] = static_cast<float>(grid.size[k]) / static_cast<float>(block * size[k]);
  }
  skip_.upload_volume(size, jump, gl::Format::r32f, false);
}

void ToleranceLayer::set_common(gl::Program& program, const ViewFrame& frame) {
  program.use();
  grid_.bind(0);
  program.set("grid", 0);
  program.set("box_lo", frame.space.local(box_.lo));
  program.set("box_hi", frame.space.local(box_.hi));
  program.set("delta", static_cast<float>(delta_));
  const auto opacity = [](const LayerSettings& layer) { return layer.shown() ? layer.opacity : 0.0f; };
  program.set("outer_tint", glm::vec4(frame.colors.outer, opacity(frame.view.outer)));
  program.set("inner_tint", glm::vec4(frame.colors.inner, opacity(frame.view.inner)));
}

void ToleranceLayer::march(gl::Program& program, const ViewFrame& frame, const gl::Texture& scene_depth,
                           float coarseness) {
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
