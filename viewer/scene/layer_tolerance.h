// Ω: ray marching of the distance grid, its boundaries as tinted translucent surfaces.
#pragma once

#include "gl/texture.h"
#include "scene/programs.h"
#include "scene/view_frame.h"
#include "tolerance/distance_grid.h"

namespace isoscope {

class ToleranceLayer {
 public:
  /// Uploads the grid; `delta` in scene units.
  void set(const DistanceGrid& grid, double delta);
  void clear() { present_ = false; }
  bool present() const { return present_; }
  /// Whether a frame with these settings shows anything of Ω.
  bool shown(const ViewSettings& view) const {
    return present_ && (view.outer.shown() || view.inner.shown());
  }
  /// Fills the bound framebuffer with premultiplied colour and depth; `coarseness` 1 at rest, more while
  /// moving.
  void march(gl::Program& program, const ViewFrame& frame, const gl::Texture& scene_depth, float coarseness);
  /// Sets what the section's shader needs to tint Ω.
  void prepare_section(gl::Program& program, const ViewFrame& frame);

 private:
  void set_common(gl::Program& program, const ViewFrame& frame);
  gl::Texture grid_, skip_;
  Box3 box_;
  glm::vec3 voxel_{1};
  glm::vec3 skip_scale_{1}; ///< of the grid's texture coordinates to those of the blocks
  double delta_ = 1;
  bool present_ = false;
};

} // namespace isoscope
