// What every layer knows while one frame is drawn.
#include "scene/view_frame.h"

#include <glad/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace isoscope {

FrameUniforms frame_uniforms(const Camera& camera, const SceneSpace& space, const ClipSettings& clip,
                             int width, int height, float pixel_scale) {
  FrameUniforms u;
  // Only the rotation comes from the single-precision matrix; the translation is taken relative to the
  // origin.
  const glm::vec3 eye = space.local(camera.eye());
  const glm::mat4 rotation = glm::mat4(glm::mat3(camera.view()));
  u.view = glm::translate(rotation, -eye);
  u.view_projection = camera.projection(static_cast<double>(width) / height) * u.view;
  u.inverse_view_projection = glm::mat4(glm::inverse(glm::dmat4(u.view_projection)));
  const CameraPose& pose = camera.pose();
  u.eye = glm::vec4(eye, pose.orthographic ? 0.0f : 1.0f);
  u.forward = glm::vec4(-glm::transpose(glm::mat3(rotation))[2], static_cast<float>(pose.distance));
  const double tangent = std::tan(glm::radians(pose.fov) / 2);
  const double pixels = 0.5 * height / (tangent * (pose.orthographic ? pose.distance : 1.0));
  u.viewport = {width, height, pixel_scale, pixels};
  u.clip_point = glm::vec4(space.local(clip.point), static_cast<float>(clip.radius));
  const Vec3 n = clip.normal;
  u.clip_normal = {n.x, n.y, n.z, clip.flipped ? -1.0 : 1.0};
  const bool cut = clip.mode == ClipSettings::Mode::cut;
  u.clip_shape = {static_cast<float>(clip.shape), cut ? 1.0f : 0.0f, 0.0f, 0.0f};
  return u;
}

FrameUniforms tile_uniforms(FrameUniforms whole, const PictureTile& tile, int width, int height) {
  const glm::dvec2 full(tile.full_width, tile.full_height), part(width, height);
  const glm::dvec2 middle((2.0 * tile.x + width) / full.x - 1, 1 - (2.0 * tile.y + height) / full.y);
  const glm::dmat4 crop =
      glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(full / part, 1)), glm::dvec3(-middle, 0));
  whole.view_projection = glm::mat4(crop * glm::dmat4(whole.view_projection));
  whole.inverse_view_projection = glm::mat4(glm::inverse(glm::dmat4(whole.view_projection)));
  whole.viewport.x = static_cast<float>(width);
  whole.viewport.y = static_cast<float>(height);
  return whole;
}

FrameUniforms moved_uniforms(FrameUniforms uniforms, glm::dvec2 pixels) {
  const glm::dvec3 shift(2 * pixels.x / static_cast<double>(uniforms.viewport.x),
                         2 * pixels.y / static_cast<double>(uniforms.viewport.y), 0);
  uniforms.view_projection =
      glm::mat4(glm::translate(glm::dmat4(1), shift) * glm::dmat4(uniforms.view_projection));
  uniforms.inverse_view_projection = glm::mat4(glm::inverse(glm::dmat4(uniforms.view_projection)));
  return uniforms;
}

glm::dvec2 still_offset(int still) {
  if (still == 0) return {0, 0};
  // Multiples of the two numbers that fill a square most evenly, however many are taken.
  const auto part = [&](double step) { return std::fmod(0.5 + still * step, 1.0) - 0.5; };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

void FrameBlock::upload(const FrameUniforms& uniforms) {
  buffer_.upload(std::span<const FrameUniforms>(&uniforms, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer_.id());
}

} // namespace isoscope
