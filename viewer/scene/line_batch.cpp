// Lines of constant pixel width with smooth edges, solid or dashed.
#include "scene/line_batch.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace isoscope {

void LineBuilder::segment(glm::vec3 from, glm::vec3 to, Color8 tint, float width, bool dashed) {
  const auto eighths = static_cast<std::uint8_t>(std::clamp(std::lround(8 * width), 1l, 255l));
  for (std::uint8_t corner = 0; corner < 4; ++corner)
    vertices_.push_back({from, to, {corner, eighths, static_cast<std::uint8_t>(dashed ? 1 : 0), 0}, tint});
}

void LineBatch::upload(const LineBuilder& builder) {
  static_assert(sizeof(LineVertex) == 32);
  count_ = builder.vertices().size() / 4;
  if (count_ == 0) return;
  buffer_.upload(std::span<const LineVertex>(builder.vertices()));
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 4> attributes{
      {{0, 3, Type::f32, 0}, {1, 3, Type::f32, 12}, {2, 4, Type::u8, 24}, {3, 4, Type::u8_normalized, 28}}};
  array_.attach(buffer_, sizeof(LineVertex), attributes);
  if (count_ <= indexed_) return;
  indexed_ = count_ + count_ / 2;
  std::vector<std::uint32_t> indices;
  indices.reserve(6 * indexed_);
  for (std::uint32_t i = 0; i < indexed_; ++i)
    for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) indices.push_back(4 * i + corner);
  indices_.upload(std::span<const std::uint32_t>(indices));
  array_.attach_indices(indices_);
}

void LineBatch::draw(gl::Program& program, float opacity, float toward) {
  if (count_ == 0) return;
  program.use();
  program.set("opacity", opacity);
  program.set("toward", toward);
  array_.bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count_), GL_UNSIGNED_INT, nullptr);
}

} // namespace isoscope
