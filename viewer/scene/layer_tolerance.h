// Ω as a volume: ray marching of the distance grid.
#pragma once

#include "gl/texture.h"
#include "scene/brick_texture.h"
#include "scene/programs.h"
#include "scene/quality_control.h"
#include "scene/view_frame.h"

#include <memory>

namespace isoscope {

class ToleranceLayer {
 public:
  /// Uploads the grid. `meets_zero`: φ is 0 between the sides.
  void set(std::shared_ptr<const DistanceGrid> grid, bool meets_zero) {
    detail_.clear();
    textures_.set(std::move(grid), meets_zero);
  }
  /// Uploads a part of Ω in finer voxels; null: there is none.
  void set_detail(std::shared_ptr<const DistanceGrid> detail) {
    if (!detail_.has(detail)) detail_.set(std::move(detail), textures_.is_signed());
  }
  void clear() {
    textures_.clear();
    detail_.clear();
  }
  bool has_detail() const { return detail_.present(); }
  bool present() const { return textures_.present(); }
  /// Whether a frame with these settings shows anything of Ω.
  bool shown(const ViewSettings& view) const {
    return present() && (view.outer.shown() || view.inner.shown());
  }
  /// Fills the bound framebuffer with premultiplied colour and depth. A moving frame shows both boundaries
  /// alone, without haze and without contours on cuts.
  void march(Programs& programs, const ViewFrame& frame, const gl::Texture& scene_depth,
             const FrameQuality& quality);
  /// Sets what the section's shader needs to tint Ω.
  void prepare_section(gl::Program& program, const ViewFrame& frame);

 private:
  void set_common(gl::Program& program, const ViewFrame& frame, bool with_detail);
  BrickTexture textures_, detail_;
};

} // namespace isoscope
