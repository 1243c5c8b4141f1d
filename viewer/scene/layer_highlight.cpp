// What the current operation touched, and what is selected.
#include "scene/layer_highlight.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

namespace isoscope {
namespace {

using Corners = std::array<Vec3, 4>;

/// Draws tetrahedra by their edges, a shared one once; those that end at a corner of the bounding box only on
/// demand, since they reach far out.
class TetEdges {
 public:
  TetEdges(const StateSnapshot& state, bool with_box, const SceneSpace& space) : space_(space) {
    if (with_box) return;
    for (const Vertex& v : state.complex.vertices)
      if (v.kind == VertexKind::box) hidden_.push_back(v.position);
  }
  void add(std::span<const Corners> tets, Color8 tint, float width, bool dashed, LineBuilder& lines) const {
    const auto hidden = [&](Vec3 q) { return std::find(hidden_.begin(), hidden_.end(), q) != hidden_.end(); };
    const auto less = [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::vector<std::array<Vec3, 2>> edges;
    for (const Corners& p : tets)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
          if (!hidden(p[i]) && !hidden(p[j]))
            edges.push_back(less(p[i], p[j]) ? std::array{p[i], p[j]} : std::array{p[j], p[i]});
    std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
      return less(a[0], b[0]) || (!less(b[0], a[0]) && less(a[1], b[1]));
    });
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& e : edges) lines.segment(space_.local(e[0]), space_.local(e[1]), tint, width, dashed);
  }
  void add(const Corners& p, Color8 tint, float width, bool dashed, LineBuilder& lines) const {
    add(std::span(&p, 1), tint, width, dashed, lines);
  }

 private:
  SceneSpace space_;
  std::vector<Vec3> hidden_;
};

/// Marks one picked element, where the state has it.
void mark(const StateSnapshot& state, const TetEdges& edges, const Pick& pick, const SceneSpace& space,
          glm::vec3 color, float strength, LineBuilder& lines, std::vector<Marker>& marks) {
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
      edges.add(state.complex.positions(TetId(pick.id)), tint, 2.2f, false, lines);
    break;
  }
}

} // namespace

void HighlightLayer::update(const StateSnapshot* state, const ViewFrame& frame) {
  LineBuilder operation, selection;
  std::vector<Marker> marks;
  if (state) {
    const SceneColors& c = frame.colors;
    const TetEdges edges(*state, frame.view.tets.box, frame.space);
    const TetEdges all_edges(*state, true, frame.space);
    if (frame.view.highlight.shown()) {
      // The first insertions replace most of T: all their edges would be a tangle.
      constexpr std::size_t shown_tets = 400;
      std::vector<Corners> added;
      for (const TetId id : state->added_tets)
        if (added.size() < shown_tets && id.index() < state->complex.tets.size() &&
            state->complex.tet(id).alive())
          added.push_back(state->complex.positions(id));
      const std::size_t removed = std::min(state->removed_tets.size(), shown_tets);
      edges.add(added, color8(c.accent, 0.8f), 1.3f, false, operation);
      edges.add(std::span(state->removed_tets).first(removed), color8(c.warning, 0.85f), 1.3f, true,
                operation);
      if (state->violated_tet) edges.add(*state->violated_tet, color8(c.bad), 2.0f, false, operation);
      if (state->inserted.valid() && state->inserted.index() < state->complex.vertices.size()) {
        const glm::vec3 p = frame.space.local(state->complex.position(state->inserted));
        const float swell = 0.5f - 0.5f * std::cos(2 * std::numbers::pi_v<float> * frame.pulse);
        marks.push_back({p, color8(c.accent), MarkerShape::disc, 7});
        marks.push_back({p, color8(c.accent), MarkerShape::ring, static_cast<std::uint8_t>(18 + 6 * swell)});
      }
    }
    mark(*state, all_edges, frame.hover, frame.space, c.selection, 0.6f, selection, marks);
    mark(*state, all_edges, frame.selection, frame.space, c.selection, 1.0f, selection, marks);
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
