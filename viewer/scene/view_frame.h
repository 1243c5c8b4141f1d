// What every layer knows while one frame is drawn, and the scene's local coordinates.
#pragma once

#include "base/geometry.h"
#include "gl/buffer.h"
#include "scene/camera.h"
#include "scene/palette.h"
#include "scene/renderer.h"
#include "scene/view_settings.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>

namespace isoscope {

/// Positions on the GPU are single precision relative to this origin.
struct SceneSpace {
  Vec3 origin;
  glm::vec3 local(Vec3 p) const {
    const Vec3 q = p - origin;
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  friend bool operator==(const SceneSpace&, const SceneSpace&) = default;
};

/// Memory image of the uniform block Frame (std140) of shaders/frame.glsl.
struct FrameUniforms {
  glm::mat4 view_projection{1}, inverse_view_projection{1}, view{1};
  glm::vec4 eye{0}, forward{0}, viewport{0}, clip_point{0}, clip_normal{0}, clip_shape{0};
};

/// Camera, viewport and clip as the shaders want them.
FrameUniforms frame_uniforms(const Camera& camera, const SceneSpace& space, const ClipSettings& clip,
                             int width, int height, float pixel_scale);

/// The same for a part of the picture, `width` by `height` pixels large.
FrameUniforms tile_uniforms(FrameUniforms whole, const PictureTile& tile, int width, int height);

/// The same moved by a part of a pixel: frames that are averaged sample different places of it.
FrameUniforms moved_uniforms(FrameUniforms uniforms, glm::dvec2 pixels);
/// Where the frame of that number samples pixels, relative to their middle: within half a pixel.
glm::dvec2 still_offset(int still);

/// One frame's circumstances.
struct ViewFrame {
  const ViewSettings& view;
  SceneColors colors;
  SceneSpace space;
  int width = 0, height = 0;
  float pixel_scale = 1;
  Quality quality = Quality::rest;
  Pick selection{}, hover{};
  float pulse = 0;
  std::optional<Vec3> mark{}; ///< a point to be seen
  double pixels_per_unit = 1; ///< at the target
  glm::vec2 rows{0, 1};       ///< heights of the frame's lower and upper rim in the picture
  Vec3 eye{};                 ///< scene coordinates
  glm::vec3 toward{0, 0, 1};  ///< unit, from the target to the eye
  float phase = 0;            ///< in [0, 1): frames that are averaged differ in it
};

/// The uniform buffer behind the block Frame.
class FrameBlock {
 public:
  void upload(const FrameUniforms& uniforms);

 private:
  gl::Buffer buffer_;
};

} // namespace isoscope
