// Where a picked element lies at a step.
#include "scene/pick_geometry.h"

#include <algorithm>

namespace isoscope {

std::optional<std::array<Vec3, 2>> edge_positions(const StateSnapshot& state, const Pick& pick) {
  const auto& vertices = state.complex.vertices;
  if (pick.kind != Pick::Kind::edge || pick.id >= vertices.size() || pick.other >= vertices.size())
    return std::nullopt;
  const bool both = vertices[pick.id].alive && vertices[pick.other].alive;
  const auto place = [&](std::uint32_t id) {
    if (!both)
      for (const StateSnapshot::Move& move : state.moves)
        if (move.vertex.value == id) return move.before;
    return vertices[id].position;
  };
  return std::array{place(pick.id), place(pick.other)};
}

Box3 pick_bounds(const StateSnapshot& state, const Pick& pick) {
  Box3 box;
  const Complex& t = state.complex;
  switch (pick.kind) {
  case Pick::Kind::none:
    break;
  case Pick::Kind::edge:
    if (const auto ends = edge_positions(state, pick))
      for (const Vec3& p : *ends) box.add(p);
    break;
  case Pick::Kind::tet:
    if (pick.id < t.tets.size() && t.tets[pick.id].alive())
      for (const Vec3& p : t.positions(TetId(pick.id))) box.add(p);
    break;
  case Pick::Kind::facet:
    if (pick.id < t.facets.size() && t.facets[pick.id].alive())
      for (const VertexId v : t.facets[pick.id].v) box.add(t.position(v));
    break;
  case Pick::Kind::vertex:
    if (pick.id < t.vertices.size()) box.add(t.vertices[pick.id].position);
    break;
  case Pick::Kind::sample:
    if (state.samples && pick.id < state.samples->size()) box.add(state.samples->positions[pick.id]);
    break;
  }
  return box;
}

} // namespace isoscope
