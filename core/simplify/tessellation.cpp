// Splits edges on a list of tetrahedra of its own and reports the difference as one delta.
#include "simplify/tessellation.h"

#include "mesh/incidence.h"
#include "mesh/predicates.h"
#include "mesh/zero_set.h"

#include <algorithm>

namespace isoscope {

namespace {

/// Γ while its edges are split: tetrahedra by number, dead ones marked, with lists by vertex.
class Splitting {
 public:
  explicit Splitting(const Complex& complex) : at_(complex.vertices.size()) {
    for (const Vertex& v : complex.vertices) positions_.push_back(v.position);
    for (std::size_t i = 0; i < complex.tets.size(); ++i) {
      if (!complex.tets[i].alive() || !complex.heterogeneous(TetId(i))) continue;
      removed_.push_back({TetId(i), complex.tets[i].v, 0});
      add(complex.tets[i].v);
    }
  }

  /// False when a tetrahedron would turn over.
  bool split(VertexId n, VertexId p, Vec3 zero) {
    const VertexId z(positions_.size());
    positions_.push_back(zero);
    at_.emplace_back();
    const std::vector<std::uint32_t> around = at_[n.index()];
    for (const std::uint32_t t : around) {
      if (!alive_[t] || !has(t, p)) continue;
      alive_[t] = false;
      for (const VertexId end : {n, p}) {
        std::array<VertexId, 4> half = tets_[t];
        std::replace(half.begin(), half.end(), end, z);
        if (!positive(half)) return false;
        add(half);
      }
    }
    return true;
  }

  const std::vector<TetRecord>& removed() const { return removed_; }
  std::vector<std::array<VertexId, 4>> living() const {
    std::vector<std::array<VertexId, 4>> tets;
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (alive_[t]) tets.push_back(tets_[t]);
    }
    return tets;
  }

 private:
  std::vector<Vec3> positions_;
  std::vector<std::array<VertexId, 4>> tets_;
  std::vector<bool> alive_;
  std::vector<std::vector<std::uint32_t>> at_; ///< dead tetrahedra included
  std::vector<TetRecord> removed_;

  void add(const std::array<VertexId, 4>& v) {
    for (const VertexId corner : v) at_[corner.index()].push_back(static_cast<std::uint32_t>(tets_.size()));
    tets_.push_back(v);
    alive_.push_back(true);
  }
  bool has(std::uint32_t t, VertexId v) const {
    return std::find(tets_[t].begin(), tets_[t].end(), v) != tets_[t].end();
  }
  bool positive(const std::array<VertexId, 4>& v) const {
    return orientation(positions_[v[0].index()], positions_[v[1].index()], positions_[v[2].index()],
                       positions_[v[3].index()]) > 0;
  }
};

std::int8_t side_of(const Complex& complex, const std::array<VertexId, 4>& v) {
  for (const VertexId corner : v) {
    if (corner.index() >= complex.vertices.size()) continue; // a new zero
    const double f = complex.value(corner);
    if (f != 0) return f > 0 ? 1 : -1;
  }
  return 0;
}

} // namespace

Result<Delta> mutual_tessellation(const Complex& complex) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  delta.form = {ZeroForm::interpolated, ZeroForm::embedded};
  Splitting splitting(complex);
  for (const ZeroSet::ZeroVertex& zero : extract_zero_set(complex).vertices) {
    if (!splitting.split(zero.negative, zero.positive, zero.position)) {
      return Error{ErrorCode::internal,
                   "Mutual tessellation would turn a tetrahedron over at the edge of the vertices " +
                       std::to_string(zero.negative.value) + " and " + std::to_string(zero.positive.value) +
                       ".",
                   "Take a larger tolerance."};
    }
    Vertex vertex;
    vertex.position = zero.position;
    vertex.value = 0;
    vertex.kind = VertexKind::zero;
    delta.added_vertices.push_back(vertex);
  }

  delta.removed = splitting.removed();
  const auto living = splitting.living();
  std::size_t fresh = complex.tets.size();
  for (std::size_t i = 0; i < living.size(); ++i) {
    const TetId slot = i < delta.removed.size() ? delta.removed[i].id : TetId(fresh++);
    delta.added.push_back({slot, canonical_order(living[i]), side_of(complex, living[i])});
  }
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const TetId t(i);
    if (!complex.tets[i].alive() || complex.heterogeneous(t)) continue;
    delta.sides.push_back({t, 0, side_of(complex, complex.tets[i].v)});
  }
  return delta;
}

Delta departure(const Complex& complex) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  delta.facet_slots_before = static_cast<std::uint32_t>(complex.facets.size());
  delta.form = {ZeroForm::embedded, ZeroForm::free};
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const Tet& tet = complex.tets[i];
    if (tet.alive()) delta.removed.push_back({TetId(i), tet.v, tet.side, tet.dropped});
  }
  const ZeroSet z = extract_zero_set(complex);
  std::vector<bool> on_zero_set(complex.vertices.size(), false);
  for (const ZeroSet::ZeroVertex& v : z.vertices) on_zero_set[v.negative.index()] = true;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    if (complex.vertices[v].alive && !on_zero_set[v]) delta.killed_vertices.push_back(VertexId(v));
  }
  std::size_t slot = 0;
  for (const ZeroSet::Polygon& p : z.polygons) {
    delta.added_facets.push_back(
        {FacetId(slot++),
         {z.vertices[p.v[0]].negative, z.vertices[p.v[1]].negative, z.vertices[p.v[2]].negative}});
  }
  return delta;
}

} // namespace isoscope
