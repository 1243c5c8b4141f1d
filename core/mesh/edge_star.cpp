// What follows from a star alone: positions after the collapse, the edge's kind, its facets of Z.
#include "mesh/edge_star.h"

#include <algorithm>

namespace isoscope {

std::array<Vec3, 4> EdgeStar::positions(const StarTet& t) const {
  return {vertices[t.v[0]].position, vertices[t.v[1]].position, vertices[t.v[2]].position,
          vertices[t.v[3]].position};
}

std::array<double, 4> EdgeStar::values(const StarTet& t) const {
  return {vertices[t.v[0]].value, vertices[t.v[1]].value, vertices[t.v[2]].value, vertices[t.v[3]].value};
}

TetLabels EdgeStar::labels(const StarTet& t) const {
  return {vertices[t.v[0]].label(), vertices[t.v[1]].label(), vertices[t.v[2]].label(),
          vertices[t.v[3]].label()};
}

std::array<VertexId, 4> EdgeStar::ids(const StarTet& t) const {
  return {vertices[t.v[0]].id, vertices[t.v[1]].id, vertices[t.v[2]].id, vertices[t.v[3]].id};
}

std::array<Vec3, 4> EdgeStar::positions_after(const StarTet& t, Vec3 target) const {
  std::array<Vec3, 4> p = positions(t);
  for (std::size_t k = 0; k < 4; ++k) {
    if (t.v[k] < 2) p[k] = target;
  }
  return p;
}

std::pair<VertexId, VertexId> oriented_edge(const Complex& complex, VertexId a, VertexId b) {
  const bool a_zero = complex.value(a) == 0, b_zero = complex.value(b) == 0;
  if (a_zero != b_zero) return a_zero ? std::pair(a, b) : std::pair(b, a);
  return a < b ? std::pair(a, b) : std::pair(b, a);
}

EdgeKind EdgeStar::kind() const {
  const StarVertex &a = vertices[0], &b = vertices[1];
  if (a.kind == VertexKind::box || b.kind == VertexKind::box) return EdgeKind::other;
  std::int8_t first_side = 0;
  bool several_sides = false, in_gamma = false, outside_gamma = false;
  for (const StarTet& t : tets) {
    if (!t.ring()) continue;
    if (first_side == 0) first_side = t.side;
    several_sides |= t.side != first_side;
    const TetLabels l = labels(t);
    const bool carries = label_count(l) > 1 || std::find(l.begin(), l.end(), 0) != l.end();
    in_gamma |= carries;
    outside_gamma |= !carries;
  }
  if (a.value == 0 && b.value == 0) return several_sides ? EdgeKind::zero : EdgeKind::other;
  if (a.value == 0 || b.value == 0) return form == ZeroForm::embedded ? EdgeKind::mixed : EdgeKind::other;
  if (a.label() != b.label()) return EdgeKind::other;
  return form == ZeroForm::interpolated && in_gamma && outside_gamma ? EdgeKind::gamma : EdgeKind::other;
}

std::vector<StarFacet> zero_facets(const EdgeStar& star) {
  struct Side {
    std::array<std::uint16_t, 3> key, outward;
    std::int8_t side;
  };
  std::vector<Side> sides;
  for (const EdgeStar::StarTet& t : star.tets) {
    if (t.side == 0) continue;
    for (const auto& local : outward_facets) {
      const std::array<std::uint16_t, 3> outward{t.v[local[0]], t.v[local[1]], t.v[local[2]]};
      std::array<std::uint16_t, 3> key = outward;
      std::sort(key.begin(), key.end());
      if (key[0] < 2) sides.push_back({key, outward, t.side});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) { return x.key < y.key; });
  std::vector<StarFacet> facets;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &s = sides[i], &o = sides[i + 1];
    if (s.key != o.key || s.side == o.side) continue;
    // Outward of the tetrahedron of the smaller label is the side of the larger one.
    const auto [back, front] = std::minmax(s.side, o.side);
    facets.push_back({s.side == back ? s.outward : o.outward,
                      {front, back},
                      s.key[0] == 0,
                      s.key[0] == 1 || s.key[1] == 1});
  }
  return facets;
}

} // namespace isoscope
