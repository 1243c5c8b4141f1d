// Flat-shaded triangles with marked edges: built on the CPU, drawn opaque or translucent.
#include "scene/mesh_batch.h"

#include <glad/gl.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isoscope {

Color8 color8(glm::vec3 rgb, float alpha) {
  const auto byte = [](float v) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
  };
  return {byte(rgb.x), byte(rgb.y), byte(rgb.z), byte(alpha)};
}

void MeshBuilder::triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, Color8 tint, std::uint8_t edges) {
  glm::vec3 n = glm::cross(b - a, c - a);
  const float length = glm::length(n);
  n = length > 0 ? n / length : glm::vec3(0, 0, 1);
  const auto part = [](float v) { return static_cast<std::int8_t>(std::lround(127.0f * v)); };
  const std::array<std::int8_t, 3> normal{part(n.x), part(n.y), part(n.z)};
  for (const glm::vec3& p : {a, b, c}) vertices_.push_back({p, normal, edges, tint});
}

void MeshBuilder::quad(const std::array<glm::vec3, 4>& p, Color8 tint) {
  const glm::vec3 d02 = p[2] - p[0], d13 = p[3] - p[1];
  if (glm::dot(d02, d02) <= glm::dot(d13, d13)) {
    triangle(p[0], p[1], p[2], tint, 1 | 4);
    triangle(p[0], p[2], p[3], tint, 1 | 2);
  } else {
    triangle(p[1], p[2], p[3], tint, 1 | 4);
    triangle(p[1], p[3], p[0], tint, 1 | 2);
  }
}

void MeshBuilder::tetrahedron(const std::array<glm::vec3, 4>& p, float shrink, Color8 tint) {
  const glm::vec3 center = 0.25f * (p[0] + p[1] + p[2] + p[3]);
  std::array<glm::vec3, 4> q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = center + shrink * (p[i] - center);
  // Positively oriented: these triples look outward.
  triangle(q[0], q[2], q[1], tint);
  triangle(q[0], q[1], q[3], tint);
  triangle(q[0], q[3], q[2], tint);
  triangle(q[1], q[2], q[3], tint);
}

void MeshBatch::upload(const MeshBuilder& builder) {
  static_assert(sizeof(MeshVertex) == 20);
  count_ = builder.vertices().size();
  if (count_ == 0) return;
  buffer_.upload(std::span<const MeshVertex>(builder.vertices()));
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 4> attributes{{{0, 3, Type::f32, 0},
                                                 {1, 3, Type::i8_normalized, 12},
                                                 {2, 1, Type::u8, 15},
                                                 {3, 4, Type::u8_normalized, 16}}};
  array_.attach(buffer_, sizeof(MeshVertex), attributes);
}

void MeshBatch::draw(gl::Program& program, const MeshStyle& style) {
  if (count_ == 0) return;
  program.use();
  program.set("opacity", style.opacity);
  program.set("edge_colour", style.edge_color);
  program.set("edge_width", style.edge_width);
  program.set("back_shade", style.back_shade);
  program.set("walls", style.walls ? 1 : 0);
  if (style.walls) {
    program.set("front_tint", style.walls->front.tint);
    program.set("front_ink", style.walls->front.ink);
    program.set("front_hatch", static_cast<int>(style.walls->front.hatch));
    program.set("back_tint", style.walls->back.tint);
    program.set("back_ink", style.walls->back.ink);
    program.set("back_hatch", static_cast<int>(style.walls->back.hatch));
  }
  array_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count_));
}

} // namespace isoscope
