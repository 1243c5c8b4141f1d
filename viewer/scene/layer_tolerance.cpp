// Ω as a volume: ray marching of the distance grid.
#include "scene/layer_tolerance.h"

#include <glad/gl.h>

namespace isoscope {

namespace {

/// Units of the textures of the whole, of the depth of what is opaque, of the detail.
constexpr int depth_unit = 3, detail_unit = 4;

} // namespace

void ToleranceLayer::set_common(gl::Program& program, const ViewFrame& frame, bool with_detail) {
  program.use();
  textures_.prepare(frame.view.level);
  if (with_detail) detail_.prepare(frame.view.level);
  textures_.set_uniforms(program, frame.space);
  if (with_detail) detail_.set_uniforms(program, frame.space, detail_unit, "detail_");
  program.set("level", frame.view.level);
  program.set("delta", static_cast<float>(textures_.grid().delta));
  const auto opacity = [](const LayerSettings& layer) { return layer.shown() ? layer.opacity : 0.0f; };
  program.set("outer_tint", glm::vec4(frame.colors.outer, opacity(frame.view.outer)));
  program.set("inner_tint", glm::vec4(frame.colors.inner, opacity(frame.view.inner)));
}

void ToleranceLayer::march(Programs& programs, const ViewFrame& frame, const gl::Texture& scene_depth,
                           const FrameQuality& quality) {
  const bool moving = quality.coarseness > 1;
  // What is inside of Ω is seen through its outer boundary.
  const ViewSettings& view = frame.view;
  const glm::vec3 haze =
      view.outer.shown() ? glm::vec3(view.haze_outer, view.haze_middle, view.haze_inner) : glm::vec3(0);
  const bool with_detail = !moving && has_detail(), with_haze = haze.x + haze.y + haze.z > 0;
  auto& pair = moving        ? programs.volume_moving
               : with_haze   ? (with_detail ? programs.volume_haze_detail : programs.volume_haze)
               : with_detail ? programs.volume_detail
                             : programs.volume;
  gl::Program& program = pair[textures_.is_signed() ? 0 : 1];
  set_common(program, frame, with_detail);
  scene_depth.bind(depth_unit);
  program.set("scene_depth", depth_unit);
  program.set("haze", haze);
  program.set("jitter_phase", frame.phase);
  program.set("ray_pixels", static_cast<float>(1 / quality.volume_scale));
  program.set("max_steps", moving ? 96 : 400);
  program.set("coarseness", quality.coarseness);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ToleranceLayer::prepare_section(gl::Program& program, const ViewFrame& frame) {
  set_common(program, frame, has_detail());
}

} // namespace isoscope
