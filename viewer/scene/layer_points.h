// Points of the input as sprites in the colour of their weight; crosses where a point was dropped.
#pragma once

#include "gl/buffer.h"
#include "scene/clip.h"
#include "scene/input_points.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace isoscope {

class PointsLayer {
 public:
  void update(std::shared_ptr<const InputPoints> points, const Clip& clip, const SceneColors& colors,
              const ViewFrame& frame);
  void clear() { kept_.count = dropped_.count = 0; }
  /// Draws at most `budget` sprites, and fewer where they would merge on the screen; which ones are left out
  /// follows from a stable order, so that nothing flickers.
  void draw(gl::Program& program, const ViewFrame& frame, std::size_t budget);

 private:
  struct Class {
    gl::Buffer indices;
    gl::VertexArray array;
    std::size_t count = 0;
  };
  void upload(const SceneColors& colors, const ViewFrame& frame);

  std::shared_ptr<const InputPoints> points_;
  SceneSpace space_;
  ThemeKind theme_ = ThemeKind::dark;
  std::vector<std::uint32_t> order_; ///< every prefix is an even thinning
  gl::Buffer vertices_;
  Class kept_, dropped_;
};

} // namespace isoscope
