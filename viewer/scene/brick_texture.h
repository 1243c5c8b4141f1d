// A distance grid as textures: bricks side by side, and which place has which.
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/view_frame.h"
#include "tolerance/distance_grid.h"

#include <memory>
#include <vector>

namespace isoscope {

class BrickTexture {
 public:
  /// Uploads the grid. `meets_zero`: φ is 0 between the sides, so that it may be drawn as a signed function;
  /// else sides have a texture of their own.
  void set(std::shared_ptr<const DistanceGrid> grid, bool meets_zero);
  void clear();
  bool present() const { return grid_ != nullptr; }
  /// Whether values have the sign of their side.
  bool is_signed() const { return signed_; }
  const DistanceGrid& grid() const { return *grid_; }
  /// Binds textures to the units 0 to 2 and sets what shaders/bricks.glsl asks for.
  void set_uniforms(gl::Program& program, const SceneSpace& space, float level);

 private:
  std::shared_ptr<const DistanceGrid> grid_;
  std::vector<float> least_;
  gl::Texture bricks_, sides_, places_;
  float entries_level_ = -1; ///< what `places_` is made for
  bool signed_ = true;
  glm::vec3 atlas_size_{1}; ///< of `bricks_`, in samples
};

} // namespace isoscope
