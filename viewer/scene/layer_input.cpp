// The input triangles.
#include "scene/layers.h"

namespace isoscope {

void InputLayer::update(const TriangleSoup& soup, const Clip& clip, const SceneColors& colors,
                        const SceneSpace& space) {
  const Color8 tint = color8(colors.input);
  MeshBuilder builder;
  builder.reserve(soup.triangles.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    if (clip.active() && !clip.cuts() && !clip.shows_cell(t)) continue;
    builder.triangle(space.local(t[0]), space.local(t[1]), space.local(t[2]), tint);
  }
  batch_.upload(builder);
}

void InputLayer::draw(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.input.opacity;
  style.back_shade = 0.7f;
  style.edge_color = glm::vec4(frame.colors.input_edge, 0.7f);
  style.edge_width = 1.0f * frame.pixel_scale;
  batch_.draw(program, style);
}

} // namespace isoscope
