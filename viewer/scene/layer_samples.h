// Samples as sprites: good discs, bad crosses; full on the outer side, rings on the inner; diamonds over the
// rim, on no side. Once Z has left T nothing classifies them, and they are drawn without a verdict.
#pragma once

#include "gl/buffer.h"
#include "questions/snapshot.h"
#include "scene/clip.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace isoscope {

class SamplesLayer {
 public:
  void update(const StateSnapshot& state, const ViewSettings& view, const Clip& clip,
              const SceneSpace& space);
  void clear();
  /// Draws at most `budget` sprites, bad ones first, those over the rim last, and fewer where they would
  /// merge on the screen. Which ones are left out follows from a stable hash, so that nothing flickers.
  void draw(gl::Program& program, const ViewFrame& frame, std::size_t budget);
  /// How many the last draw left out.
  std::size_t thinned() const { return thinned_; }

 private:
  void upload_positions(std::shared_ptr<const BoundarySamples> samples, const SceneSpace& space);
  struct Class {
    gl::Buffer indices;
    gl::VertexArray array;
    std::size_t count = 0;
  };
  /// How a class is drawn; sizes in pixels.
  struct Look {
    glm::vec3 tint;
    int glyph = 0; ///< as in shaders/sample.frag
    float size = 1, smallest = 1.6f, opacity = 1;
  };
  void draw_class(gl::Program& program, const ViewFrame& frame, Class& group, std::size_t count,
                  const Look& look) const;

  std::shared_ptr<const BoundarySamples> samples_;
  SceneSpace space_;
  std::vector<std::uint32_t> order_, over_rim_order_; ///< every prefix is an even thinning
  gl::Buffer positions_, over_rim_positions_;
  Class good_, bad_, over_rim_;
  bool classified_ = true;
  std::size_t thinned_ = 0;
};

} // namespace isoscope
