// Passes over a whole picture, which have no vertices: the ground of a frame, and the average of frames.
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/frame_targets.h"
#include "scene/palette.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace isoscope {

/// Owns the vertex array without vertices that they draw.
class FullScreenPasses {
 public:
  FullScreenPasses();
  ~FullScreenPasses();
  FullScreenPasses(const FullScreenPasses&) = delete;
  FullScreenPasses& operator=(const FullScreenPasses&) = delete;

  /// For who draws the triangle that covers the picture.
  void bind() const;
  /// Covers the target that is bound with the program that is used.
  void draw() const;
  /// Depths of the target that is bound are cleared, the ground is drawn, and what is in front is kept from
  /// then on. `rows`: of the whole picture that the target has, from 0 to 1.
  void begin_opaque(gl::Program& background, const SceneColors& colors, glm::vec2 rows, float opacity) const;
  /// Adds a picture to the average of the targets with this weight; nothing where there is no room for one.
  void average(FrameTargets& targets, gl::Program& copy, const gl::Texture& picture, float weight) const;

 private:
  std::uint32_t empty_array_ = 0;
};

/// Binds nothing any more, for whoever draws next.
void leave_frame();

} // namespace isoscope
