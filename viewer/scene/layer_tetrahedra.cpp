// Tetrahedra as shrunk copies: violating ones solid in their condition's colour, the others faint.
#include "scene/layers.h"

namespace isoscope {

glm::vec3 role_color(TetRole role, const SceneColors& colors) {
  switch (role) {
  case TetRole::violates_1:
    return colors.bad;
  case TetRole::violates_2:
    return colors.warning;
  case TetRole::violates_3:
    return colors.misoriented;
  case TetRole::changed:
    return colors.accent;
  case TetRole::hidden:
  case TetRole::plain:
    break;
  }
  return colors.tetrahedron;
}

void TetrahedraLayer::update(const StateSnapshot& state, const TetFilter& filter, bool side_tint,
                             const Clip& clip, const SceneColors& colors, const SceneSpace& space) {
  constexpr float plain_alpha = 0.13f, changed_alpha = 0.34f;
  MeshBuilder solid, faint;
  const bool rooms = state.zero_set.has_rooms();
  for_each_visible_tet(state, filter, clip, [&](TetId id, TetRole role) {
    const std::array<Vec3, 4> corners = state.complex.positions(id);
    std::array<glm::vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = space.local(corners[i]);
    const bool violates = role != TetRole::plain && role != TetRole::changed;
    const float alpha = violates ? 1.0f : (role == TetRole::changed ? changed_alpha : plain_alpha);
    // A box tetrahedron is large: it stays faint whatever it violates, or it would hide everything.
    const bool box = (state.tet_flags[id.index()] & tet_box) != 0;
    const bool sided = side_tint && !violates && state.complex.form == ZeroForm::embedded;
    const glm::vec3 color =
        sided ? side_color(state.complex.tet(id).side, rooms, colors) : role_color(role, colors);
    const Color8 tint = color8(color, box ? std::min(alpha, 0.16f) : sided ? 0.2f : alpha);
    (violates && !box ? solid : faint).tetrahedron(p, filter.shrink, tint);
  });
  solid_.upload(solid);
  faint_.upload(faint);
}

void TetrahedraLayer::clear() {
  solid_.upload(MeshBuilder());
  faint_.upload(MeshBuilder());
}

void TetrahedraLayer::draw_solid(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.tetrahedra.opacity;
  style.edge_color = glm::vec4(0.08f, 0.08f, 0.09f, 0.55f);
  style.edge_width = 1.1f * frame.pixel_scale;
  style.back_shade = 1;
  solid_.draw(program, style);
}

void TetrahedraLayer::draw_faint(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.tetrahedra.opacity;
  style.edge_color = glm::vec4(frame.colors.tetrahedron_edge, 0.42f);
  style.edge_width = 1.1f * frame.pixel_scale;
  style.back_shade = 1;
  faint_.draw(program, style);
}

} // namespace isoscope
