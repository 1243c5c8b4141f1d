// Where a picked element lies at a step.
#include "scene/pick_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isoscope {

namespace {

constexpr double arrow_pixels = 28; ///< of an enlarged move

} // namespace

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

Vec3 surface_normal(const StateSnapshot& state, const Pick& pick) {
  Vec3 sum;
  if (pick.kind != Pick::Kind::edge && pick.kind != Pick::Kind::vertex) return sum;
  const ZeroSet& zero = state.zero_set;
  for (const ZeroSet::Polygon& p : zero.polygons)
    for (std::size_t i = 0; i < p.count; ++i) {
      const ZeroSet::ZeroVertex& v = zero.vertices[p.v[i]];
      const auto touches = [&](std::uint32_t id) { return v.negative.value == id || v.positive.value == id; };
      if (!touches(pick.id) && !touches(pick.other)) continue;
      const Vec3 a = v.position, b = zero.vertices[p.v[(i + 1) % p.count]].position,
                 c = zero.vertices[p.v[(i + 2) % p.count]].position;
      sum += cross(b - a, c - a);
    }
  return normalized(sum);
}

double move_scale(const StateSnapshot& state, double pixels_per_unit) {
  constexpr std::size_t sweep = 4;
  constexpr double quantile = 0.9; ///< the moves up to here decide; few long ones must not hide the others
  if (state.moves.size() < sweep) return 1;
  std::vector<double> lengths;
  for (const StateSnapshot::Move& m : state.moves) lengths.push_back(distance(m.before, m.after));
  const auto at =
      lengths.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(lengths.size() - 1));
  std::nth_element(lengths.begin(), at, lengths.end());
  const double ratio = arrow_pixels / (*at * pixels_per_unit);
  if (!(ratio > 1) || !std::isfinite(ratio)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(ratio)));
  return decade * (ratio >= 5 * decade ? 5 : ratio >= 2 * decade ? 2 : 1);
}

Vec3 arrow_tip(const StateSnapshot::Move& move, double scale, double pixels_per_unit) {
  const double length = distance(move.before, move.after), most = 2 * arrow_pixels / pixels_per_unit;
  const double factor = length > 0 ? std::clamp(most / length, 1.0, std::max(scale, 1.0)) : 1;
  return move.before + factor * (move.after - move.before);
}

} // namespace isoscope
