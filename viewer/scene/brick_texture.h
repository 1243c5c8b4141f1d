// A distance grid as textures: bricks side by side, and which place has which.
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "scene/view_frame.h"
#include "tolerance/distance_grid.h"

#include <memory>
#include <string>
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
  /// Whether this grid is the one that was uploaded.
  bool has(const std::shared_ptr<const DistanceGrid>& grid) const { return grid_ == grid; }
  /// Makes what rays may cross for a level; before textures are bound, as it binds its own.
  void prepare(float level);
  /// Binds textures to three units and sets what shaders/bricks.glsl asks for, under names that begin so.
  void set_uniforms(gl::Program& program, const SceneSpace& space, int first_unit = 0,
                    const std::string& prefix = "");

 private:
  std::shared_ptr<const DistanceGrid> grid_;
  std::vector<float> least_;
  gl::Texture bricks_, sides_, places_;
  float entries_level_ = -1; ///< what `places_` is made for
  bool signed_ = true;
  float largest_ = 1;       ///< φ/δ of what `bricks_` has as 1
  glm::vec3 atlas_size_{1}; ///< of `bricks_`, in samples
};

} // namespace isoscope
