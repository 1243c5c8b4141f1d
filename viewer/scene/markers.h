// A few camera-facing marks of fixed pixel size: rings around points, discs and crosses of the 2D section,
// candidates of a collapse.
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "journal/vocabulary.h"
#include "scene/mesh_batch.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace isoscope {

/// 20 bytes.
struct Marker {
  glm::vec3 position;
  Color8 tint;
  MarkerShape shape = MarkerShape::ring;
  std::uint8_t diameter = 16; ///< interface pixels
  std::array<std::uint8_t, 2> unused{};
};

class MarkerBatch {
 public:
  void upload(const std::vector<Marker>& markers);
  void draw(gl::Program& program, float opacity);

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
  std::size_t count_ = 0;
};

} // namespace isoscope
