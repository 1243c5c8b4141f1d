// Where a picked element lies at a step.
#include "scene/pick_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isoscope {

namespace {

constexpr double arrow_pixels = 28; ///< of an enlarged move
constexpr double facing = 0.3;      ///< cosine to the normal from which a surface is seen well

/// Whether the segment meets the triangle well inside both: not where it starts, on the surface itself.
bool meets(Vec3 from, Vec3 way, const Triangle3& t) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], p = cross(way, e2);
  const double det = dot(e1, p);
  if (det == 0) return false;
  const Vec3 s = from - t[0], q = cross(s, e1);
  const double u = dot(s, p) / det, v = dot(way, q) / det, along = dot(e2, q) / det;
  constexpr double start = 0.02;
  return u >= 0 && v >= 0 && u + v <= 1 && along > start && along < 1;
}

bool hidden(const ZeroSet& zero, Vec3 place, Vec3 way) {
  for (const ZeroSet::Polygon& p : zero.polygons)
    for (std::uint8_t i = 2; i < p.count; ++i)
      if (meets(place, way,
                {zero.vertices[p.v[0]].position, zero.vertices[p.v[i - 1u]].position,
                 zero.vertices[p.v[i]].position}))
        return true;
  return false;
}

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
    if (pick.id < t.tets.size() && t.tets[pick.id].alive()) {
      const auto& corners = t.tets[pick.id].v;
      const bool model = std::any_of(corners.begin(), corners.end(), [&](VertexId v) {
        return t.vertices[v.index()].kind != VertexKind::box;
      });
      for (const VertexId v : corners)
        if (!model || t.vertices[v.index()].kind != VertexKind::box) box.add(t.position(v));
    }
    break;
  case Pick::Kind::facet:
    if (pick.id < t.facets.size() && t.facets[pick.id].alive())
      for (const VertexId v : t.facets[pick.id].v) box.add(t.position(v));
    break;
  case Pick::Kind::vertex:
    if (pick.id < t.vertices.size()) box.add(t.vertices[pick.id].position);
    break;
  case Pick::Kind::point: // no state moves what the input or Ω has
  case Pick::Kind::over_rim:
    box.add(pick.point);
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

Vec3 unhidden_direction(const ZeroSet& zero, Vec3 place, Vec3 now, Vec3 normal, double reach) {
  const auto sees = [&](Vec3 d) { return dot(d, normal) >= facing && !hidden(zero, place, reach * d); };
  if (sees(now)) return now;
  if (sees(normal)) return normal;
  std::vector<Vec3> others;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) others.push_back(normalized(Vec3{double(x), double(y), double(z)}));
  const auto good = [&](Vec3 d) { return dot(d, now) + dot(d, normal); };
  std::stable_sort(others.begin(), others.end(), [&](Vec3 a, Vec3 b) { return good(a) > good(b); });
  for (const Vec3& d : others)
    if (sees(d)) return d;
  return dot(now, normal) < facing ? normal : now;
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
