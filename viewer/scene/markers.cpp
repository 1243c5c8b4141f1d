// A few camera-facing marks of fixed pixel size.
#include "scene/markers.h"

#include <glad/gl.h>

namespace isoscope {

void MarkerBatch::upload(const std::vector<Marker>& markers) {
  static_assert(sizeof(Marker) == 20);
  count_ = markers.size();
  if (count_ == 0) return;
  buffer_.upload(std::span<const Marker>(markers));
  using Type = gl::Attribute::Type;
  const std::array<gl::Attribute, 3> attributes{
      {{0, 3, Type::f32, 0}, {1, 4, Type::u8_normalized, 12}, {2, 2, Type::u8, 16}}};
  array_.attach(buffer_, sizeof(Marker), attributes);
}

void MarkerBatch::draw(gl::Program& program, float opacity) {
  if (count_ == 0) return;
  program.use();
  program.set("opacity", opacity);
  glEnable(GL_PROGRAM_POINT_SIZE);
  array_.bind();
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count_));
}

} // namespace isoscope
