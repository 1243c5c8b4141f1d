// Keeps the lists and copies stars out of a state.
#include "mesh/incidence.h"

#include "base/sort_unique.h"
#include "mesh/cost_star.h"
#include "mesh/junction.h"
#include "mesh/predicates.h"
#include "mesh/strata.h"
#include "mesh/zero_set.h"

#include <algorithm>
#include <array>

namespace isoscope {

namespace {

bool has(const Tet& t, VertexId v) {
  return std::find(t.v.begin(), t.v.end(), v) != t.v.end();
}

/// Facets of Z at one vertex of an embedded Z, each once: seen from the tetrahedron of its larger label.
void add_facets_at(const Complex& complex, std::span<const TetId> tets, VertexId v,
                   std::vector<std::pair<TetId, std::size_t>>& facets) {
  for (const TetId t : tets) {
    const Tet& tet = complex.tet(t);
    for (std::size_t k = 0; k < 4; ++k) {
      if (tet.v[k] == v || !complex.on_zero_set(t, k)) continue;
      if (complex.tet(tet.neighbor[k]).side < tet.side) facets.emplace_back(t, k);
    }
  }
}

void gather_embedded_facets(const Complex& complex, const Incidence& incidence,
                            const std::vector<VertexId>& around, std::vector<Triangle3>& out) {
  std::vector<std::pair<TetId, std::size_t>> facets;
  for (const VertexId v : around) {
    if (complex.value(v) == 0) add_facets_at(complex, incidence.tets_of(v), v, facets);
  }
  sort_unique(facets);
  for (const auto& [t, k] : facets) {
    const auto f = complex.tet(t).facet(k);
    out.push_back({complex.position(f[0]), complex.position(f[1]), complex.position(f[2])});
  }
}

std::vector<VertexId> border_neighbors(const Complex& complex, const Incidence& incidence, VertexId v) {
  std::vector<VertexId> found;
  if (complex.value(v) != 0) return found;
  for (const std::uint32_t w : borders_from(link_arcs(complex, incidence, v))) found.push_back(VertexId(w));
  return found;
}

/// The edges of the border at these vertices, each once.
void gather_borders(const Complex& complex, const Incidence& incidence, const std::vector<VertexId>& around,
                    std::vector<Segment3>& out) {
  std::vector<std::array<VertexId, 2>> edges;
  for (const VertexId v : around)
    for (const VertexId w : border_neighbors(complex, incidence, v))
      edges.push_back({std::min(v, w), std::max(v, w)});
  sort_unique(edges);
  for (const auto& [v, w] : edges) out.push_back({complex.position(v), complex.position(w)});
}

/// Follows the border from one end of an edge of it, away from the other, and adds what lies beyond the
/// vertex next to that end.
void follow_border(const Complex& complex, const Incidence& incidence, VertexId from, VertexId other,
                   std::vector<Segment3>& out) {
  // Edges may be much shorter than δ. Those left out make a check of the border stricter, not wrong.
  constexpr int most_edges = 16;
  VertexId before = other, v = from;
  for (int i = 0; i <= most_edges; ++i) {
    std::vector<VertexId> next = border_neighbors(complex, incidence, v);
    if (next.size() != 2) return;
    const VertexId after = next[0] == before ? next[1] : next[0];
    if (after == other || after == from) return;
    if (i > 0) out.push_back({complex.position(v), complex.position(after)});
    before = v;
    v = after;
  }
}

void gather_interpolated_facets(const Complex& complex, const std::vector<TetId>& tets,
                                std::vector<Triangle3>& out) {
  std::vector<LabelledTriangle> triangles;
  for (const TetId t : tets) {
    const TetLabels labels = complex.labels(t);
    if (label_count(labels) < 3) {
      const ZeroPolygon polygon =
          zero_polygon(complex.positions(t), seen_from_front(complex.values(t), labels));
      if (polygon.count >= 3) out.push_back({polygon.corner[0], polygon.corner[1], polygon.corner[2]});
      continue;
    }
    triangles.clear();
    append_zero_triangles(complex.positions(t), complex.values(t), labels, complex.tet(t).v, triangles);
    for (const LabelledTriangle& triangle : triangles) out.push_back(triangle.corners);
  }
}

/// The tetrahedra at some vertices, ascending.
std::vector<TetId> tets_at(const Incidence& incidence, std::span<const VertexId> vertices) {
  std::size_t count = 0;
  for (const VertexId v : vertices) count += incidence.tets_of(v).size();
  std::vector<TetId> tets;
  tets.reserve(count);
  for (const VertexId v : vertices) {
    const auto at = incidence.tets_of(v);
    tets.insert(tets.end(), at.begin(), at.end());
  }
  sort_unique(tets);
  return tets;
}

void add_vertex(const Complex& complex, VertexId v, EdgeStar& star) {
  const Vertex& vertex = complex.vertices[v.index()];
  star.vertices.push_back({v, vertex.position, vertex.value, vertex.kind, vertex.room});
}

void add_tet(const Complex& complex, TetId t, VertexId a, VertexId b, std::array<std::uint16_t, 4> numbers,
             EdgeStar& star) {
  const Tet& tet = complex.tet(t);
  star.tets.push_back({t, numbers, tet.side, has(tet, a), has(tet, b), tet.dropped});
}

/// Facets and borders in the error. `others`: the vertices of the star besides the ends.
void gather_cost(const Complex& complex, const Incidence& incidence, const std::vector<VertexId>& others,
                 CostRing ring, EdgeStar& star) {
  std::vector<VertexId> around{star.a(), star.b()};
  if (ring == CostRing::two) around.insert(around.end(), others.begin(), others.end());
  if (complex.form != ZeroForm::embedded) {
    gather_interpolated_facets(complex, tets_at(incidence, around), star.cost_facets);
    return;
  }
  gather_embedded_facets(complex, incidence, around, star.cost_facets);
  if (std::any_of(star.tets.begin(), star.tets.end(), [](const auto& t) { return t.dropped != 0; }))
    gather_borders(complex, incidence, around, star.cost_borders);
}

} // namespace

Incidence::Incidence(const Complex& complex) : tets_(complex.vertices.size()) {
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (complex.tets[i].alive()) add({TetId(i), complex.tets[i].v, 0});
  }
}

void Incidence::add(const TetRecord& tet) {
  for (const VertexId v : tet.v) {
    if (v.index() >= tets_.size()) tets_.resize(v.index() + 1);
    tets_[v.index()].push_back(tet.id);
  }
}

void Incidence::remove(const TetRecord& tet) {
  for (const VertexId v : tet.v) {
    auto& list = tets_[v.index()];
    const auto at = std::find(list.begin(), list.end(), tet.id);
    *at = list.back();
    list.pop_back();
  }
}

void Incidence::apply(const Delta& delta) {
  for (const TetRecord& t : delta.removed) remove(t);
  for (const TetRecord& t : delta.added) add(t);
}

bool Incidence::adjacent(const Complex& complex, VertexId a, VertexId b) const {
  const auto at = tets_of(a);
  return std::any_of(at.begin(), at.end(), [&](TetId t) { return has(complex.tet(t), b); });
}

EdgeStar gather_edge_star(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                          CostRing ring) {
  EdgeStar star;
  star.form = complex.form;
  const std::vector<TetId> tets = tets_at(incidence, std::array{a, b});
  std::vector<VertexId> others;
  others.reserve(4 * tets.size());
  for (const TetId t : tets) {
    for (const VertexId v : complex.tet(t).v) {
      if (v != a && v != b) others.push_back(v);
    }
  }
  sort_unique(others);

  star.vertices.reserve(others.size() + 2);
  add_vertex(complex, a, star);
  add_vertex(complex, b, star);
  for (const VertexId v : others) add_vertex(complex, v, star);
  const auto number = [&](VertexId v) -> std::uint16_t {
    if (v == a) return 0;
    if (v == b) return 1;
    return static_cast<std::uint16_t>(std::lower_bound(others.begin(), others.end(), v) - others.begin() + 2);
  };
  star.tets.reserve(tets.size());
  for (const TetId t : tets) {
    const auto& v = complex.tet(t).v;
    add_tet(complex, t, a, b, {number(v[0]), number(v[1]), number(v[2]), number(v[3])}, star);
  }
  gather_cost(complex, incidence, others, ring, star);
  const bool may_end =
      std::any_of(star.tets.begin(), star.tets.end(), [](const auto& t) { return t.dropped != 0; });
  if (complex.form == ZeroForm::embedded && may_end && strata_of(star).border) {
    follow_border(complex, incidence, a, b, star.border_beyond);
    follow_border(complex, incidence, b, a, star.border_beyond);
  }
  return star;
}

EdgeStar gather_cost_star(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                          CostRing ring) {
  const std::vector<TetId> tets = tets_at(incidence, std::array{a, b});
  // Where Z is no closed surface between two sides its strata ask for the facets of the star.
  if (ring != CostRing::one || !std::all_of(tets.begin(), tets.end(), [&](TetId t) {
        const Tet& tet = complex.tet(t);
        return tet.dropped == 0 && tet.side >= -1 && tet.side <= 1;
      }))
    return gather_edge_star(complex, incidence, a, b, ring);
  EdgeStar star;
  star.form = complex.form;
  star.vertices.reserve(2 + 3 * tets.size());
  add_vertex(complex, a, star);
  add_vertex(complex, b, star);
  star.tets.reserve(tets.size());
  for (const TetId t : tets) {
    std::array<std::uint16_t, 4> numbers{};
    for (std::size_t k = 0; k < 4; ++k) {
      const VertexId v = complex.tet(t).v[k];
      numbers[k] = v == a ? 0 : v == b ? 1 : static_cast<std::uint16_t>(star.vertices.size());
      if (numbers[k] > 1) add_vertex(complex, v, star);
    }
    add_tet(complex, t, a, b, numbers, star);
  }
  if (star.kind() == EdgeKind::other) return star;
  if (star.form == ZeroForm::embedded) {
    gather_embedded_facets(complex, incidence, {a, b}, star.cost_facets);
  } else {
    gather_interpolated_facets(complex, tets, star.cost_facets);
  }
  return star;
}

namespace {

/// By tetrahedron of the star (ascending): which of its facets are dropped once the edge is gone. Where a
/// tetrahedron vanishes two of its facets become one: it lies between two sides if one of them did.
std::vector<std::uint8_t> dropped_after(const Complex& complex, const std::vector<TetId>& star, VertexId a,
                                        VertexId b) {
  std::vector<std::uint8_t> dropped(star.size());
  for (std::size_t i = 0; i < star.size(); ++i) dropped[i] = complex.tet(star[i]).dropped;
  if (std::none_of(dropped.begin(), dropped.end(), [](std::uint8_t bits) { return bits != 0; }))
    return dropped;
  for (const TetId t : star) {
    const Tet& tet = complex.tet(t);
    if (!has(tet, a) || !has(tet, b)) continue;
    std::array<TetId, 2> beyond;
    unsigned bit = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (tet.v[k] != a && tet.v[k] != b) continue;
      beyond[tet.v[k] == a ? 0 : 1] = tet.neighbor[k];
      bit |= tet.dropped >> k & 1u;
    }
    if (!beyond[0].valid() || !beyond[1].valid()) continue;
    if (complex.tet(beyond[0]).side == complex.tet(beyond[1]).side) bit = 0;
    for (const TetId n : beyond) {
      const auto& around = complex.tet(n).neighbor;
      const auto k = static_cast<unsigned>(std::find(around.begin(), around.end(), t) - around.begin());
      std::uint8_t& bits =
          dropped[static_cast<std::size_t>(std::lower_bound(star.begin(), star.end(), n) - star.begin())];
      bits = static_cast<std::uint8_t>((bits & ~(1u << k)) | bit << k);
    }
  }
  return dropped;
}

} // namespace

Delta collapse_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                     Vec3 target) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  const auto at_a = incidence.tets_of(a), at_b = incidence.tets_of(b);
  std::vector<TetId> star(at_a.begin(), at_a.end());
  star.insert(star.end(), at_b.begin(), at_b.end());
  sort_unique(star);
  const std::vector<std::uint8_t> dropped = dropped_after(complex, star, a, b);
  for (std::size_t i = 0; i < star.size(); ++i) {
    const TetId t = star[i];
    const Tet& tet = complex.tet(t);
    delta.removed.push_back({t, tet.v, tet.side, tet.dropped});
    const bool has_a = std::find(tet.v.begin(), tet.v.end(), a) != tet.v.end();
    std::array<VertexId, 4> v = tet.v;
    const auto b_at = std::find(v.begin(), v.end(), b);
    if (has_a && b_at != v.end()) continue;
    if (b_at != v.end()) *b_at = a;
    const std::array<VertexId, 4> order = canonical_order(v);
    delta.added.push_back({t, order, tet.side, reordered_bits(dropped[i], v, order)});
  }
  delta.moves.push_back({a, complex.position(a), target});
  delta.killed_vertices.push_back(b);
  return delta;
}

std::optional<Delta> split_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b,
                                 Vec3 point) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  Vertex fresh;
  fresh.position = point;
  fresh.value = 0;
  fresh.kind = VertexKind::zero;
  delta.added_vertices = {fresh};
  const VertexId middle(complex.vertices.size());
  std::vector<TetId> around;
  for (const TetId t : incidence.tets_of(a))
    if (has(complex.tet(t), b)) around.push_back(t);
  std::sort(around.begin(), around.end());
  std::size_t slots = complex.tets.size();
  const auto position = [&](VertexId v) { return v == middle ? point : complex.position(v); };
  for (const TetId t : around) {
    const Tet& tet = complex.tet(t);
    delta.removed.push_back({t, tet.v, tet.side, tet.dropped});
    for (const VertexId end : {a, b}) {
      std::array<VertexId, 4> v = tet.v;
      const auto at = static_cast<std::size_t>(std::find(v.begin(), v.end(), end) - v.begin());
      const VertexId other = end == a ? b : a;
      v[at] = middle;
      if (orientation(position(v[0]), position(v[1]), position(v[2]), position(v[3])) <= 0)
        return std::nullopt;
      // The facet opposite the end that stays is the new one between the halves.
      const auto inner = static_cast<std::size_t>(std::find(v.begin(), v.end(), other) - v.begin());
      const auto dropped = static_cast<std::uint8_t>(tet.dropped & ~(1u << inner));
      const std::array<VertexId, 4> ordered = canonical_order(v);
      const TetId slot = end == a ? t : TetId(slots++);
      delta.added.push_back({slot, ordered, tet.side, reordered_bits(dropped, v, ordered)});
    }
  }
  std::sort(delta.added.begin(), delta.added.end(),
            [](const TetRecord& x, const TetRecord& y) { return x.id < y.id; });
  return delta;
}

std::optional<Delta> flip_delta(const Complex& complex, const Incidence& incidence, VertexId a, VertexId b) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  std::vector<TetId> around;
  for (const TetId t : incidence.tets_of(a))
    if (has(complex.tet(t), b)) around.push_back(t);
  if (around.size() != 4) return std::nullopt;
  std::sort(around.begin(), around.end());
  // What is opposite in Z, with sides that differ to its both sides, and the apex of each side.
  std::vector<VertexId> opposite;
  std::array<VertexId, 2> apex; // of the negative side, of the positive one
  for (const TetId t : around) {
    const Tet& tet = complex.tet(t);
    if (tet.dropped != 0) return std::nullopt;
    delta.removed.push_back({t, tet.v, tet.side, tet.dropped});
    for (std::size_t k = 0; k < 4; ++k) {
      if (tet.v[k] == a || tet.v[k] == b) continue;
      const auto other = std::find_if(tet.v.begin(), tet.v.end(),
                                      [&](VertexId v) { return v != a && v != b && v != tet.v[k]; });
      if (!complex.on_zero_set(t, k)) continue;
      opposite.push_back(*other);
      apex[tet.side > 0 ? 1 : 0] = tet.v[k];
    }
  }
  sort_unique(opposite);
  if (opposite.size() != 2 || !apex[0].valid() || !apex[1].valid() || apex[0] == apex[1]) return std::nullopt;
  auto [c, d] = std::array{opposite[0], opposite[1]};
  if (incidence.adjacent(complex, c, d)) return std::nullopt;
  const auto turns = [&](VertexId p, VertexId q, VertexId r, VertexId s) {
    return orientation(complex.position(p), complex.position(q), complex.position(r), complex.position(s));
  };
  if (turns(a, b, c, apex[1]) < 0) std::swap(c, d);
  const std::array<std::array<VertexId, 4>, 4> made{
      {{d, c, a, apex[1]}, {c, d, b, apex[1]}, {c, d, a, apex[0]}, {d, c, b, apex[0]}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& v = made[i];
    if (turns(v[0], v[1], v[2], v[3]) <= 0) return std::nullopt;
    delta.added.push_back({around[i], canonical_order(v), static_cast<std::int8_t>(i < 2 ? 1 : -1), 0});
  }
  return delta;
}

} // namespace isoscope
