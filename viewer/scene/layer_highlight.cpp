// What the current operation touched, and what is selected.
#include "scene/layers.h"

#include "base/point_order.h"
#include "scene/first_box.h"
#include "scene/pick_geometry.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
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
    std::vector<std::array<Vec3, 2>> edges;
    for (const Corners& p : tets)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
          if (!hidden(p[i]) && !hidden(p[j]))
            edges.push_back(lies_before(p[i], p[j]) ? std::array{p[i], p[j]} : std::array{p[j], p[i]});
    std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
      return lies_before(a[0], b[0]) || (!lies_before(b[0], a[0]) && lies_before(a[1], b[1]));
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

/// The edges of facets of Z, a shared one once.
void add_facet_edges(std::span<const Triangle3> facets, const SceneSpace& space, Color8 tint, float width,
                     bool dashed, LineBuilder& lines) {
  std::vector<std::array<Vec3, 2>> edges;
  for (const Triangle3& t : facets)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = t[i], b = t[(i + 1) % 3];
      edges.push_back(lies_before(a, b) ? std::array{a, b} : std::array{b, a});
    }
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
    return lies_before(a[0], b[0]) || (!lies_before(b[0], a[0]) && lies_before(a[1], b[1]));
  });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& e : edges) lines.segment(space.local(e[0]), space.local(e[1]), tint, width, dashed);
}

/// The twelve edges of a box.
void add_box(const Box3& box, const SceneSpace& space, Color8 tint, LineBuilder& lines) {
  if (box.empty()) return;
  for (unsigned corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1u) != 0) continue;
      Vec3 a;
      for (int i = 0; i < 3; ++i) a[i] = (corner >> i & 1u) != 0 ? box.hi[i] : box.lo[i];
      Vec3 b = a;
      b[axis] = box.hi[axis];
      lines.segment(space.local(a), space.local(b), tint, 1.6f);
    }
}

/// An arrow of a move; its head faces the viewer.
void add_arrow(Vec3 from, Vec3 to, const ViewFrame& frame, Color8 tint, LineBuilder& lines) {
  if (from == to) return;
  const glm::vec3 a = frame.space.local(from), b = frame.space.local(to);
  lines.segment(a, b, tint, 2.0f);
  const glm::vec3 along = b - a;
  const float head =
      std::min(0.35f * glm::length(along), static_cast<float>(9 * frame.pixel_scale / frame.pixels_per_unit));
  glm::vec3 across = glm::cross(along, frame.toward);
  if (glm::length(across) < 1e-6f * glm::length(along)) across = glm::cross(along, glm::vec3(0, 1, 0.1f));
  const glm::vec3 back = b - head * glm::normalize(along), side = 0.5f * head * glm::normalize(across);
  lines.segment(b, back + side, tint, 2.0f);
  lines.segment(b, back - side, tint, 2.0f);
}

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
  case Pick::Kind::point:
  case Pick::Kind::over_rim:
    ring(pick.point);
    break;
  case Pick::Kind::edge:
    if (const auto ends = edge_positions(state, pick)) {
      lines.segment(space.local((*ends)[0]), space.local((*ends)[1]), tint, 3.4f);
      for (const Vec3& p : *ends) marks.push_back({space.local(p), tint, MarkerShape::disc, 7});
    }
    break;
  case Pick::Kind::facet:
    if (pick.id < state.complex.facets.size() && state.complex.facets[pick.id].alive()) {
      const auto& v = state.complex.facets[pick.id].v;
      const Triangle3 corners{state.complex.position(v[0]), state.complex.position(v[1]),
                              state.complex.position(v[2])};
      add_facet_edges(std::span(&corners, 1), space, tint, 3.0f, false, lines);
    }
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
      add_box(first_box(*state), frame.space, color8(c.tetrahedron_edge, 0.9f), operation);
      // The first insertions replace most of T: all their edges would be a tangle.
      constexpr std::size_t shown_tets = 400;
      std::vector<Corners> added;
      for (const TetId id : state->added_tets)
        if (added.size() < shown_tets && id.index() < state->complex.tets.size() &&
            state->complex.tet(id).alive())
          added.push_back(state->complex.positions(id));
      const std::size_t removed = std::min(state->removed_tets.size(), shown_tets);
      const bool facets = !state->added_facets.empty() || !state->removed_facets.empty();
      const bool before = frame.view.moment == Moment::before, after = frame.view.moment == Moment::after;
      if (facets) {
        // On Z its facets tell the story; those of T around them would be a tangle.
        // Where all of Z is new, as after the tessellation, its own edges say as much.
        constexpr std::size_t shown_facets = 400;
        if (!before && state->added_facets.size() <= shown_facets)
          add_facet_edges(state->added_facets, frame.space, color8(c.accent, 1), 2.0f, false, operation);
        if (!after && state->removed_facets.size() <= shown_facets)
          add_facet_edges(state->removed_facets, frame.space, color8(c.warning, 0.9f), 1.6f, !before,
                          operation);
      } else {
        if (!before) edges.add(added, color8(c.accent, 0.8f), 1.3f, false, operation);
        if (!after)
          edges.add(std::span(state->removed_tets).first(removed), color8(c.warning, 0.85f), 1.3f, true,
                    operation);
      }
      const double pixels = frame.pixels_per_unit / static_cast<double>(frame.pixel_scale);
      const double enlarged = move_scale(*state, pixels);
      for (const StateSnapshot::Move& move : state->moves)
        add_arrow(move.before, arrow_tip(move, enlarged, pixels), frame, color8(c.selection, 0.95f),
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
