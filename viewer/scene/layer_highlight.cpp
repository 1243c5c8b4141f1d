// What the current operation touched, and what is selected.
#include "scene/layer_highlight.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {
namespace {

std::array<glm::vec3, 4> local(const std::array<Vec3, 4>& p, const SceneSpace& space) {
  return {space.local(p[0]), space.local(p[1]), space.local(p[2]), space.local(p[3])};
}

/// Marks one picked element, where the state has it.
void mark(const StateSnapshot& state, const Pick& pick, const SceneSpace& space, glm::vec3 color,
          float strength, LineBuilder& lines, std::vector<Marker>& marks) {
  const Color8 tint = color8(color, strength);
  const auto ring = [&](Vec3 p) { marks.push_back({space.local(p), tint, MarkerShape::ring, 17}); };
  switch (pick.kind) {
  case Pick::Kind::none:
    break;
  case Pick::Kind::vertex:
    if (pick.id < state.complex.vertices.size()) ring(state.complex.vertices[pick.id].position);
    break;
  case Pick::Kind::sample:
    if (state.samples && pick.id < state.samples->size()) ring(state.samples->positions[pick.id]);
    break;
  case Pick::Kind::tet:
    if (pick.id < state.complex.tets.size() && state.complex.tets[pick.id].alive())
      lines.tetrahedron(local(state.complex.positions(TetId(pick.id)), space), tint, 2.2f);
    break;
  }
}

} // namespace

void HighlightLayer::update(const StateSnapshot* state, const ViewFrame& frame) {
  LineBuilder operation, selection;
  std::vector<Marker> marks;
  if (state) {
    const SceneColors& c = frame.colors;
    if (frame.view.highlight.shown()) {
      constexpr std::size_t shown_tets =
          400; // the first insertions replace most of T: its edges would be a tangle
      const std::size_t added = std::min(state->added_tets.size(), shown_tets);
      for (std::size_t i = 0; i < added; ++i) {
        const TetId id = state->added_tets[i];
        if (id.index() < state->complex.tets.size() && state->complex.tet(id).alive())
          operation.tetrahedron(local(state->complex.positions(id), frame.space), color8(c.accent, 0.55f),
                                1.2f);
      }
      const std::size_t removed = std::min(state->removed_tets.size(), shown_tets);
      for (std::size_t i = 0; i < removed; ++i)
        operation.tetrahedron(local(state->removed_tets[i], frame.space), color8(c.warning, 0.65f), 1.2f,
                              true);
      if (state->violated_tet)
        operation.tetrahedron(local(*state->violated_tet, frame.space), color8(c.bad, 0.95f), 2.0f);
      if (state->inserted.valid() && state->inserted.index() < state->complex.vertices.size()) {
        const glm::vec3 p = frame.space.local(state->complex.position(state->inserted));
        const float swell = 0.5f - 0.5f * std::cos(2 * std::numbers::pi_v<float> * frame.pulse);
        marks.push_back({p, color8(c.accent), MarkerShape::disc, 7});
        marks.push_back({p, color8(c.accent), MarkerShape::ring, static_cast<std::uint8_t>(18 + 6 * swell)});
      }
    }
    mark(*state, frame.hover, frame.space, c.selection, 0.6f, selection, marks);
    mark(*state, frame.selection, frame.space, c.selection, 1.0f, selection, marks);
  }
  operation_.upload(operation);
  selection_.upload(selection);
  marks_.upload(marks);
}

void HighlightLayer::draw(Programs& programs, const ViewFrame& frame) {
  const float opacity = frame.view.highlight.shown() ? frame.view.highlight.opacity : 0;
  const auto pass = [&](float strength) {
    operation_.draw(programs.line, opacity * strength);
    selection_.draw(programs.line, strength, 1e-3f);
    marks_.draw(programs.marker, strength);
  };
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  pass(0.28f);
  glDepthFunc(GL_LEQUAL);
  pass(1.0f);
  glDepthMask(GL_TRUE);
}

} // namespace isoscope
