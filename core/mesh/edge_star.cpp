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

EdgeKind EdgeStar::kind() const {
  const StarVertex &a = vertices[0], &b = vertices[1];
  if (a.kind == VertexKind::box || b.kind == VertexKind::box) return EdgeKind::other;
  if (form == ZeroForm::embedded) return embedded_kind();
  if (a.value == 0 || b.value == 0 || a.label() != b.label()) return EdgeKind::other;
  bool in_gamma = false, outside_gamma = false;
  for (const StarTet& t : tets) {
    if (!t.ring()) continue;
    const bool carries = carries_zero_set(labels(t));
    in_gamma |= carries;
    outside_gamma |= !carries;
  }
  return form == ZeroForm::interpolated && in_gamma && outside_gamma ? EdgeKind::gamma : EdgeKind::other;
}

EdgeKind EdgeStar::embedded_kind() const {
  bool at_a = vertices[0].value == 0, at_b = vertices[1].value == 0, at_edge = false;
  if (std::any_of(tets.begin(), tets.end(), [](const StarTet& t) { return t.dropped != 0; })) {
    // Facets that are dropped have vertices with F = 0 too.
    at_a = at_b = false;
    for (const StarFacet& f : zero_facets(*this)) {
      at_a |= f.at_a;
      at_b |= f.at_b;
      at_edge |= f.ring();
    }
  } else {
    const auto in_ring = [](const StarTet& t) { return t.ring(); };
    const auto first = std::find_if(tets.begin(), tets.end(), in_ring);
    at_edge =
        std::any_of(first, tets.end(), [&](const StarTet& t) { return t.ring() && t.side != first->side; });
  }
  if (at_a && at_b) return at_edge ? EdgeKind::zero : EdgeKind::other;
  return at_a || at_b ? EdgeKind::mixed : EdgeKind::other;
}

std::vector<StarFacet> side_facets(const EdgeStar& star) {
  struct Side {
    std::array<std::uint16_t, 3> key, outward;
    std::int8_t side;
    bool dropped;
  };
  std::vector<Side> sides;
  for (const EdgeStar::StarTet& t : star.tets) {
    if (t.side == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& local = outward_facets[k];
      const std::array<std::uint16_t, 3> outward{t.v[local[0]], t.v[local[1]], t.v[local[2]]};
      std::array<std::uint16_t, 3> key = outward;
      std::sort(key.begin(), key.end());
      if (key[0] < 2) sides.push_back({key, outward, t.side, (t.dropped >> k & 1u) != 0});
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
                      s.key[0] == 1 || s.key[1] == 1,
                      s.dropped});
  }
  return facets;
}

std::vector<StarFacet> zero_facets(const EdgeStar& star) {
  std::vector<StarFacet> facets = side_facets(star);
  std::erase_if(facets, [](const StarFacet& f) { return f.dropped; });
  return facets;
}

} // namespace isoscope
