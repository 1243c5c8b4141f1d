// One triangle that is larger than the picture.
#include "scene/full_screen_passes.h"

#include <glad/gl.h>

namespace isoscope {

FullScreenPasses::FullScreenPasses() {
  glGenVertexArrays(1, &empty_array_);
}

FullScreenPasses::~FullScreenPasses() {
  glDeleteVertexArrays(1, &empty_array_);
}

void FullScreenPasses::bind() const {
  glBindVertexArray(empty_array_);
}

void FullScreenPasses::draw() const {
  bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FullScreenPasses::begin_opaque(gl::Program& background, const SceneColors& colors, glm::vec2 rows,
                                    float opacity) const {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  background.use();
  background.set("top", colors.ground_top);
  background.set("bottom", colors.ground_bottom);
  background.set("rows", rows);
  background.set("opacity", opacity);
  glDepthMask(GL_FALSE);
  draw();
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
}

void FullScreenPasses::average(FrameTargets& targets, gl::Program& copy, const gl::Texture& picture,
                               float weight) const {
  if (!targets.prepare_average()) return;
  targets.averaging.bind(targets.width, targets.height);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendColor(0, 0, 0, weight);
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  copy.use();
  picture.bind(0);
  copy.set("picture", 0);
  draw();
  glDisable(GL_BLEND);
}

void leave_frame() {
  glBindVertexArray(0);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

} // namespace isoscope
