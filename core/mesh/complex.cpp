// Applies and undoes deltas on the plain arrays; neighbours are found again across the hole's boundary.
#include "mesh/complex.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace isoscope {

namespace {

/// A facet of a tetrahedron, ordered by its sorted vertices so that its two sides become neighbours in a
/// sorted list.
struct FacetSide {
  std::uint64_t low = 0;  ///< smallest and middle vertex
  std::uint32_t high = 0; ///< largest vertex
  TetId tet;
  std::uint8_t facet = 0;

  bool same_facet(const FacetSide& o) const { return low == o.low && high == o.high; }
  bool operator<(const FacetSide& o) const { return low != o.low ? low < o.low : high < o.high; }
};

FacetSide facet_side(const std::array<VertexId, 4>& v, TetId tet, int facet) {
  std::uint32_t a = v[(facet + 1) & 3].value, b = v[(facet + 2) & 3].value, c = v[(facet + 3) & 3].value;
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {std::uint64_t{a} << 32 | b, c, tet, static_cast<std::uint8_t>(facet)};
}

/// Makes the two sides of each facet neighbours. Returns how many facets of tetrahedra were left with one
/// side.
std::size_t connect(std::vector<Tet>& tets, std::vector<FacetSide>& sides) {
  std::sort(sides.begin(), sides.end());
  std::size_t open = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const FacetSide& a = sides[i];
    if (i + 1 == sides.size() || !a.same_facet(sides[i + 1])) {
      open += a.tet.valid();
      continue;
    }
    const FacetSide& b = sides[++i];
    if (a.tet.valid()) tets[a.tet.index()].neighbor[a.facet] = b.tet;
    if (b.tet.valid()) tets[b.tet.index()].neighbor[b.facet] = a.tet;
  }
  return open;
}

/// Finds neighbours across facets of the whole hull: for deltas that lay facets of T bare, or cover them when
/// undone.
void connect_hull(std::vector<Tet>& tets) {
  std::vector<FacetSide> sides;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (int i = 0; i < 4 && tets[t].alive(); ++i) {
      if (!tets[t].neighbor[static_cast<std::size_t>(i)].valid()) {
        sides.push_back(facet_side(tets[t].v, TetId(t), i));
      }
    }
  }
  connect(tets, sides);
}

/// Replaces the tetrahedra `out` by `in`. What bounded the hole on its outer side is found through the
/// neighbours of `out`.
void exchange(std::vector<Tet>& tets, const std::vector<TetRecord>& out, const std::vector<TetRecord>& in) {
  std::vector<FacetSide> sides;
  sides.reserve(4 * in.size() + 2 * out.size() + 16);
  for (const TetRecord& r : out) tets[r.id.index()].v = {};
  for (const TetRecord& r : out) {
    for (int i = 0; i < 4; ++i) {
      const TetId n = tets[r.id.index()].neighbor[static_cast<std::size_t>(i)];
      if (n.valid() && !tets[n.index()].alive()) continue;
      // A facet that was hull is noted with an invalid tetrahedron, so that it may stay hull.
      FacetSide& side = sides.emplace_back(facet_side(r.v, n, i));
      if (!n.valid()) continue;
      auto& back = tets[n.index()].neighbor;
      const auto at = std::find(back.begin(), back.end(), r.id);
      assert(at != back.end());
      side.facet = static_cast<std::uint8_t>(at - back.begin());
      *at = TetId{};
    }
  }
  for (const TetRecord& r : out) tets[r.id.index()] = Tet{};
  for (const TetRecord& r : in) {
    assert(!tets[r.id.index()].alive());
    tets[r.id.index()].v = r.v;
    tets[r.id.index()].side = r.side;
    tets[r.id.index()].dropped = r.dropped;
    for (int i = 0; i < 4; ++i) sides.push_back(facet_side(r.v, r.id, i));
  }
  if (connect(tets, sides) > 0 && !in.empty()) connect_hull(tets);
}

/// Replaces facets of a free Z; their slots need no neighbours.
void exchange_facets(std::vector<ZeroFacet>& facets, const std::vector<FacetRecord>& out,
                     const std::vector<FacetRecord>& in) {
  for (const FacetRecord& r : out) facets[r.id.index()] = {};
  for (const FacetRecord& r : in) {
    if (r.id.index() >= facets.size()) facets.resize(r.id.index() + 1);
    facets[r.id.index()].v = r.v;
  }
}

} // namespace

std::array<VertexId, 4> canonical_order(std::array<VertexId, 4> v) {
  bool odd = false;
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = i; k > 0 && v[k] < v[k - 1]; --k) {
      std::swap(v[k], v[k - 1]);
      odd = !odd;
    }
  }
  if (odd) std::swap(v[2], v[3]);
  return v;
}

std::uint8_t reordered_bits(std::uint8_t bits, const std::array<VertexId, 4>& from,
                            const std::array<VertexId, 4>& to) {
  unsigned result = 0;
  for (std::size_t i = 0; bits != 0 && i < 4; ++i) {
    if ((bits >> i & 1u) != 0) result |= 1u << (std::find(to.begin(), to.end(), from[i]) - to.begin());
  }
  return static_cast<std::uint8_t>(result);
}

bool Delta::empty() const {
  return added_vertices.empty() && killed_vertices.empty() && values.empty() && moves.empty() &&
         removed.empty() && added.empty() && sides.empty() && dropped.empty() && removed_facets.empty() &&
         added_facets.empty() && !sample_set && !form;
}

std::size_t Delta::memory_bytes() const {
  return sizeof(Delta) + added_vertices.capacity() * sizeof(Vertex) +
         killed_vertices.capacity() * sizeof(VertexId) + values.capacity() * sizeof(ValueChange) +
         moves.capacity() * sizeof(Move) + (removed.capacity() + added.capacity()) * sizeof(TetRecord) +
         sides.capacity() * sizeof(SideChange) + dropped.capacity() * sizeof(DroppedChange) +
         (removed_facets.capacity() + added_facets.capacity()) * sizeof(FacetRecord) +
         facet_labels.capacity() * sizeof(LabelPair);
}

std::array<Vec3, 4> Complex::positions(TetId t) const {
  const auto& v = tet(t).v;
  return {position(v[0]), position(v[1]), position(v[2]), position(v[3])};
}

std::array<double, 4> Complex::values(TetId t) const {
  const auto& v = tet(t).v;
  return {value(v[0]), value(v[1]), value(v[2]), value(v[3])};
}

TetLabels Complex::labels(TetId t) const {
  const auto& v = tet(t).v;
  return {label(v[0]), label(v[1]), label(v[2]), label(v[3])};
}

bool Complex::heterogeneous(TetId t) const {
  return label_count(labels(t)) > 1;
}

bool Complex::on_zero_set(TetId t, std::size_t i) const {
  const TetId n = tet(t).neighbor[i];
  return n.valid() && tet(t).side != tet(n).side && (tet(t).dropped >> i & 1u) == 0;
}

bool Complex::in_gamma(TetId t) const {
  return carries_zero_set(labels(t));
}

std::size_t Complex::alive_tets() const {
  return static_cast<std::size_t>(
      std::count_if(tets.begin(), tets.end(), [](const Tet& t) { return t.alive(); }));
}

std::size_t Complex::memory_bytes() const {
  return sizeof(Complex) + vertices.capacity() * sizeof(Vertex) + tets.capacity() * sizeof(Tet) +
         facets.capacity() * sizeof(ZeroFacet) + facet_labels.capacity() * sizeof(LabelPair);
}

void Complex::apply(const Delta& delta) {
  vertices.insert(vertices.end(), delta.added_vertices.begin(), delta.added_vertices.end());
  for (const VertexId v : delta.killed_vertices) vertices[v.index()].alive = false;
  for (const auto& c : delta.values) vertices[c.vertex.index()].value = c.after;
  for (const auto& m : delta.moves) vertices[m.vertex.index()].position = m.after;
  for (const auto& s : delta.sides) tets[s.tet.index()].side = s.after;
  for (const auto& d : delta.dropped) tets[d.tet.index()].dropped = d.after;
  if (delta.form) form = delta.form->after, facet_labels = delta.facet_labels;
  exchange_facets(facets, delta.removed_facets, delta.added_facets);
  if (delta.removed.empty() && delta.added.empty()) return;
  assert(delta.slots_before == tets.size());
  std::size_t slots = tets.size();
  for (const TetRecord& r : delta.added) slots = std::max(slots, r.id.index() + 1);
  tets.resize(slots);
  exchange(tets, delta.removed, delta.added);
}

void Complex::undo(const Delta& delta) {
  if (!delta.removed.empty() || !delta.added.empty()) {
    exchange(tets, delta.added, delta.removed);
    tets.resize(delta.slots_before);
  }
  if (!delta.removed_facets.empty() || !delta.added_facets.empty()) {
    exchange_facets(facets, delta.added_facets, delta.removed_facets);
    facets.resize(delta.facet_slots_before);
  }
  if (delta.form) form = delta.form->before, facet_labels.clear();
  for (const auto& d : delta.dropped) tets[d.tet.index()].dropped = d.before;
  for (const auto& s : delta.sides) tets[s.tet.index()].side = s.before;
  for (auto m = delta.moves.rbegin(); m != delta.moves.rend(); ++m) {
    vertices[m->vertex.index()].position = m->before;
  }
  for (auto c = delta.values.rbegin(); c != delta.values.rend(); ++c) {
    vertices[c->vertex.index()].value = c->before;
  }
  for (const VertexId v : delta.killed_vertices) vertices[v.index()].alive = true;
  vertices.resize(vertices.size() - delta.added_vertices.size());
}

AffineFunction interpolate(const std::array<Vec3, 4>& p, const std::array<double, 4>& f) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Vec3 sum = (f[1] - f[0]) * bc + (f[2] - f[0]) * ca + (f[3] - f[0]) * ab;
  return {p[0], sum / dot(a, bc), f[0]};
}

} // namespace isoscope
