// Flat-shaded triangles with marked edges: built on the CPU, drawn opaque or translucent.
#pragma once

#include "gl/buffer.h"
#include "scene/palette.h"
#include "scene/programs.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

using Color8 = std::array<std::uint8_t, 4>;
Color8 color8(glm::vec3 rgb, float alpha = 1);

/// 20 bytes; three in a row make a triangle.
struct MeshVertex {
  glm::vec3 position;
  std::array<std::int8_t, 3> normal;
  std::uint8_t edges; ///< bit i: the edge opposite corner i is drawn
  Color8 tint;
};

/// Collects triangles.
class MeshBuilder {
 public:
  /// Corners counter-clockwise seen from the side the normal points to.
  void triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, Color8 tint, std::uint8_t edges = 7);
  /// Four corners in order, split along the shorter diagonal, which is not drawn.
  void quad(const std::array<glm::vec3, 4>& p, Color8 tint);
  /// A tetrahedron's four facets, shrunk about its centroid.
  void tetrahedron(const std::array<glm::vec3, 4>& p, float shrink, Color8 tint);
  void clear() { vertices_.clear(); }
  void reserve(std::size_t triangles) { vertices_.reserve(3 * triangles); }
  const std::vector<MeshVertex>& vertices() const { return vertices_; }

 private:
  std::vector<MeshVertex> vertices_;
};

/// What the two sides of walls between rooms show, instead of the triangles' own colours: a ground with a
/// hatch of ink.
struct WallStyle {
  struct Side {
    glm::vec3 tint{0}, ink{0};
    Hatch hatch = Hatch::none;
  };
  Side front, back;
};

/// How a batch is shaded.
struct MeshStyle {
  float opacity = 1;
  std::optional<WallStyle> walls{};
  glm::vec4 edge_color{0};
  float edge_width = 0; ///< pixels, 0 none
  float back_shade = 0.55f;
};

/// The triangles on the GPU.
class MeshBatch {
 public:
  void upload(const MeshBuilder& builder);
  bool empty() const { return count_ == 0; }
  std::size_t triangles() const { return count_ / 3; }
  void draw(gl::Program& program, const MeshStyle& style);

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
  std::size_t count_ = 0;
};

} // namespace isoscope
