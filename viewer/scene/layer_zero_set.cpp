// Z: shaded polygons with their edges.
#include "scene/layers.h"

#include "scene/zero_facets.h"

namespace isoscope {

void ZeroSetLayer::update(const StateSnapshot& state, Moment moment, const Clip& clip,
                          const SceneColors& colors, const SceneSpace& space) {
  const ZeroSet& zero = state.zero_set;
  const Color8 tint = color8(colors.zero_set);
  MeshBuilder builder;
  builder.reserve(2 * zero.polygons.size());
  const std::vector<std::uint8_t> is_new =
      moment == Moment::before ? new_polygons(state) : std::vector<std::uint8_t>(zero.polygons.size(), 0);
  for (std::size_t index = 0; index < zero.polygons.size(); ++index) {
    const ZeroSet::Polygon& polygon = zero.polygons[index];
    if (is_new[index] || !shows_polygon(state, polygon, clip)) continue;
    std::array<glm::vec3, 4> p{};
    for (std::size_t i = 0; i < polygon.count; ++i) p[i] = space.local(zero.vertices[polygon.v[i]].position);
    if (polygon.count == 3)
      builder.triangle(p[0], p[1], p[2], tint);
    else
      builder.quad(p, tint);
  }
  if (moment == Moment::before)
    for (const Triangle3& t : state.removed_facets)
      builder.triangle(space.local(t[0]), space.local(t[1]), space.local(t[2]), tint);
  batch_.upload(builder);
}

void ZeroSetLayer::draw(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.zero_set.opacity;
  style.back_shade = 0.5f;
  if (frame.view.zero_set_edges) {
    style.edge_color = glm::vec4(frame.colors.zero_set_edge, 0.85f);
    style.edge_width = 1.1f * frame.pixel_scale;
  }
  batch_.draw(program, style);
}

} // namespace isoscope
