// Ω: ray marching of the distance grid, its boundaries as tinted translucent surfaces.
#pragma once

#include "gl/texture.h"
#include "scene/empty_space.h"
#include "scene/programs.h"
#include "scene/view_frame.h"
#include "tolerance/distance_grid.h"

namespace isoscope {

class ToleranceLayer {
 public:
  /// Uploads the grid; `delta` in scene units. `meets_zero`: φ is 0 between the sides, so that it may be
  /// drawn as a signed function, which is right where voxels are coarser than Ω too.
  void set(const DistanceGrid& grid, double delta, bool meets_zero);
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
  gl::Texture grid_, skip_, sides_;
  GridBlocks blocks_;
  float skip_level_ = 0; ///< what the texture of jumps is made for
  Box3 box_;
  glm::vec3 voxel_{1};
  glm::vec3 skip_scale_{1}; ///< of the grid's texture coordinates to those of the blocks
  double delta_ = 1;
  bool present_ = false, signed_ = true;
};

} // namespace isoscope
