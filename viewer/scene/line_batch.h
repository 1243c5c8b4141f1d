// Lines of constant pixel width with smooth edges, solid or dashed.
#pragma once

#include "gl/buffer.h"
#include "scene/mesh_batch.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// 32 bytes; four in a row make a segment.
struct LineVertex {
  glm::vec3 from, to;
  std::array<std::uint8_t, 4> shape; ///< corner bits, width in eighths of a pixel, dashed, unused
  Color8 tint;
};

/// Collects segments.
class LineBuilder {
 public:
  /// Width in interface pixels, at most 31.
  void segment(glm::vec3 from, glm::vec3 to, Color8 tint, float width, bool dashed = false);
  void clear() { vertices_.clear(); }
  const std::vector<LineVertex>& vertices() const { return vertices_; }

 private:
  std::vector<LineVertex> vertices_;
};

/// The segments on the GPU.
class LineBatch {
 public:
  void upload(const LineBuilder& builder);
  bool empty() const { return count_ == 0; }
  /// `toward`: how far the lines are moved towards the viewer, as a part of the distance, to lie on top of
  /// facets.
  void draw(gl::Program& program, float opacity, float toward = 5e-4f);

 private:
  gl::Buffer buffer_, indices_;
  gl::VertexArray array_;
  std::size_t count_ = 0, indexed_ = 0;
};

} // namespace isoscope
