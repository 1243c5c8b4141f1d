// Splits tetrahedra, facets and edges on a list of tetrahedra of its own and reports the difference as one
// delta.
#include "simplify/tessellation.h"

#include "base/numbers.h"
#include "base/place.h"
#include "mesh/junction.h"
#include "mesh/predicates.h"
#include "mesh/zero_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

namespace isoscope {

namespace {

/// Γ while it is split: tetrahedra by number, dead ones marked, with lists by vertex.
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

  /// Puts a vertex inside the simplex of these vertices and joins it to all around. False, with nothing
  /// changed, when a tetrahedron would turn over.
  bool split(std::span<const VertexId> simplex, Vec3 point) {
    const VertexId z(positions_.size());
    positions_.push_back(point);
    std::vector<std::uint32_t> around;
    std::vector<std::array<VertexId, 4>> parts;
    bool good = true;
    for (const std::uint32_t t : at_[simplex.front().index()]) {
      if (!alive_[t] || !has_all(t, simplex)) continue;
      around.push_back(t);
      for (const VertexId corner : simplex) {
        std::array<VertexId, 4>& part = parts.emplace_back(tets_[t]);
        std::replace(part.begin(), part.end(), corner, z);
        good = good && positive(part);
      }
    }
    if (!good) {
      positions_.pop_back();
      return false;
    }
    at_.emplace_back();
    for (const std::uint32_t t : around) alive_[t] = false;
    for (const auto& part : parts) add(part);
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
  bool has_all(std::uint32_t t, std::span<const VertexId> simplex) const {
    return std::all_of(simplex.begin(), simplex.end(), [&](VertexId v) {
      return std::find(tets_[t].begin(), tets_[t].end(), v) != tets_[t].end();
    });
  }
  bool positive(const std::array<VertexId, 4>& v) const {
    return orientation(positions_[v[0].index()], positions_[v[1].index()], positions_[v[2].index()],
                       positions_[v[3].index()]) > 0;
  }
};

std::int8_t side_of(const Complex& complex, const std::array<VertexId, 4>& v) {
  for (const VertexId corner : v) {
    if (corner.index() >= complex.vertices.size()) continue; // a new zero
    if (const std::int8_t label = complex.label(corner); label != 0) return label;
  }
  return 0;
}

/// The spacing of doubles at the farthest coordinate of a point.
double spacing_at(Vec3 p) {
  const double farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
}

/// Splits an edge at its zero. Where rounding puts that into a tetrahedron that would turn over, a double
/// next to it may be sound, or one farther along the edge: nothing where none is.
std::optional<Vec3> split_edge(Splitting& splitting, std::span<const VertexId> edge, Vec3 zero, Vec3 negative,
                               Vec3 positive) {
  if (splitting.split(edge, zero)) return zero;
  const double spacing = spacing_at(zero);
  const auto split_around = [&](Vec3 place) -> std::optional<Vec3> {
    for (const int x : {0, 1, -1})
      for (const int y : {0, 1, -1})
        for (const int z : {0, 1, -1}) {
          const Vec3 p = place + spacing * Vec3{double(x), double(y), double(z)};
          if (splitting.split(edge, p)) return p;
        }
    return std::nullopt;
  };
  for (const double share : {0.0, 1.0 / 64, 1.0 / 16, 1.0 / 4})
    for (const Vec3 end : {negative, positive})
      if (const auto place = split_around(zero + share * (end - zero))) return place;
  return std::nullopt;
}

Error turned_over(Vec3 where, double spacing) {
  return {ErrorCode::unsupported,
          "The digits of the coordinates do not suffice to make Z facets of T near " +
              place(where, proof_digits) + ", where they go in steps of " + general(spacing, 3) + ".",
          "Move the model to the origin where it was made, or choose a larger tolerance."};
}

/// A tetrahedron of three labels or more, or a facet of three: where its zeros are joined.
struct Meeting {
  std::vector<VertexId> simplex;
  Vec3 center;
};

/// Tetrahedra first, then their facets: afterwards no tetrahedron has more than two labels.
std::vector<Meeting> meetings(const Complex& complex) {
  std::vector<Meeting> tets;
  std::map<std::array<VertexId, 3>, Vec3> facets;
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const TetId t(i);
    if (!complex.tets[i].alive()) continue;
    const TetLabels labels = complex.labels(t);
    if (label_count(labels) < 3) continue;
    const Tet& tet = complex.tets[i];
    const Junction junction = make_junction(complex.positions(t), complex.values(t), labels, tet.v);
    tets.push_back({{tet.v.begin(), tet.v.end()}, junction.center()});
    for (std::size_t k = 0; k < 4; ++k) {
      TetLabels rest = labels;
      rest[k] = 0;
      if (label_count(rest) < 3) continue;
      std::array<VertexId, 3> facet = tet.facet(k);
      std::sort(facet.begin(), facet.end());
      facets.emplace(facet, junction.position[Junction::first_facet + k]);
    }
  }
  for (const auto& [facet, center] : facets) tets.push_back({{facet.begin(), facet.end()}, center});
  return tets;
}

} // namespace

Result<Delta> mutual_tessellation(const Complex& complex) {
  Delta delta;
  delta.slots_before = static_cast<std::uint32_t>(complex.tets.size());
  delta.form = {ZeroForm::interpolated, ZeroForm::embedded};
  Splitting splitting(complex);
  const auto add_vertex = [&](Vec3 position) {
    Vertex vertex;
    vertex.position = position;
    vertex.value = 0;
    vertex.kind = VertexKind::zero;
    delta.added_vertices.push_back(vertex);
  };
  for (const Meeting& meeting : meetings(complex)) {
    Vec3 middle;
    for (const VertexId v : meeting.simplex)
      middle = middle + complex.position(v) / static_cast<double>(meeting.simplex.size());
    // Rounding may put the centre of a thin simplex on a facet: towards the middle there is more room.
    Vec3 center = meeting.center;
    bool split = splitting.split(meeting.simplex, center);
    for (int k = 1; k <= 2 && !split; ++k) {
      center = meeting.center + 0.5 * k * (middle - meeting.center);
      split = splitting.split(meeting.simplex, center);
    }
    if (!split) return turned_over(center, spacing_at(center));
    add_vertex(center);
  }
  for (const ZeroSet::ZeroVertex& zero : extract_zero_set(complex).vertices) {
    if (zero.junction) continue;
    const std::array<VertexId, 2> edge{zero.negative, zero.positive};
    const auto place = split_edge(splitting, edge, zero.position, complex.position(zero.negative),
                                  complex.position(zero.positive));
    if (!place) return turned_over(zero.position, spacing_at(zero.position));
    add_vertex(*place);
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
  const bool rooms = z.has_rooms();
  for (const ZeroSet::Polygon& p : z.polygons) {
    if (rooms) delta.facet_labels.push_back(p.labels);
    delta.added_facets.push_back(
        {FacetId(slot++),
         {z.vertices[p.v[0]].negative, z.vertices[p.v[1]].negative, z.vertices[p.v[2]].negative}});
  }
  return delta;
}

Delta free_start(const TriangleMesh& mesh) {
  Delta delta;
  delta.form = {ZeroForm::interpolated, ZeroForm::free};
  for (const Vec3 p : mesh.points) {
    Vertex v;
    v.position = p;
    v.kind = VertexKind::zero;
    delta.added_vertices.push_back(v);
  }
  std::size_t slot = 0;
  for (const auto& t : mesh.triangles)
    delta.added_facets.push_back({FacetId(slot++), {VertexId(t[0]), VertexId(t[1]), VertexId(t[2])}});
  return delta;
}

} // namespace isoscope
