// The 2D section of a state by a plane: segments and points in the plane's coordinates.
#include "scene/section_geometry.h"

#include "base/labels.h"
#include "mesh/sample_sets.h"
#include "mesh/zero_curves.h"
#include "scene/plane_cut.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace isoscope {
namespace {

using Segment = SectionGeometry::Segment;

/// Where a convex polygon with the given heights meets the plane.
std::optional<Segment> cut(std::span<const Vec3> p, std::span<const double> height,
                           const SectionPlane& plane) {
  const auto ends = cut_polygon(
      p.size(), [&](std::size_t i) { return height[i]; },
      [&](std::size_t i, std::size_t j, double t) { return plane.project(p[i] + t * (p[j] - p[i])); });
  return ends ? std::optional(Segment{(*ends)[0], (*ends)[1]}) : std::nullopt;
}

constexpr std::array<std::array<std::size_t, 3>, 4> facets{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

bool drawn(const StateSnapshot& state, std::size_t tet, bool box) {
  return state.complex.tets[tet].alive() &&
         (box || tet >= state.tet_flags.size() || (state.tet_flags[tet] & tet_box) == 0);
}

/// The polygon in which the plane cuts a tetrahedron that has corners on both sides. Its orientation counts
/// for nothing.
std::optional<SectionGeometry::Cell> cut_cell(const std::array<Vec3, 4>& p, const std::array<double, 4>& h,
                                              const SectionPlane& plane) {
  std::array<std::size_t, 4> above{}, below{};
  std::size_t na = 0, nb = 0;
  for (std::size_t i = 0; i < 4; ++i) (h[i] >= 0 ? above[na++] : below[nb++]) = i;
  if (na == 0 || nb == 0) return std::nullopt;
  const auto meet = [&](std::size_t a, std::size_t b) {
    return plane.project(p[a] + h[a] / (h[a] - h[b]) * (p[b] - p[a]));
  };
  SectionGeometry::Cell cell;
  if (na == 2) {
    cell.count = 4;
    cell.corners = {meet(above[0], below[0]), meet(above[0], below[1]), meet(above[1], below[1]),
                    meet(above[1], below[0])};
  } else {
    const std::size_t apex = na == 1 ? above[0] : below[0];
    const auto& base = na == 1 ? below : above;
    cell.count = 3;
    for (std::size_t i = 0; i < 3; ++i) cell.corners[i] = meet(apex, base[i]);
  }
  return cell;
}

/// The parts of a tetrahedron by label, in tetrahedra: each part is a cone from the mean of the zeros over
/// what it has of the facets, as that mean lies on Z.
class PartsByLabel {
 public:
  PartsByLabel(const Complex& complex, TetId t)
      : p_(complex.positions(t)), values_(complex.values(t)), labels_(complex.labels(t)) {}

  /// Calls visit(tetrahedron, label) for each piece; for none where a corner is on Z.
  template <class Visit> void for_each(const Visit& visit) const {
    if (std::find(labels_.begin(), labels_.end(), 0) != labels_.end()) return;
    if (label_count(labels_) == 1) return visit(p_, labels_[0]);
    const Vec3 apex = mean_zero(std::array<std::size_t, 4>{0, 1, 2, 3});
    for (const auto& f : facets) {
      for (std::size_t r = 0; r < 3; ++r) {
        const std::size_t x = f[r], y = f[(r + 1) % 3], z = f[(r + 2) % 3];
        const bool one_label = labels_[x] == labels_[y] && labels_[x] == labels_[z];
        const Vec3 middle = one_label ? (1.0 / 3) * (p_[x] + p_[y] + p_[z]) : mean_zero(f);
        visit(std::array{p_[x], end(x, y), middle, apex}, labels_[x]);
        visit(std::array{p_[x], middle, end(x, z), apex}, labels_[x]);
      }
    }
  }

 private:
  /// How far the part of x reaches along an edge: to the zero, or halfway to a corner of its own label.
  Vec3 end(std::size_t x, std::size_t y) const {
    if (labels_[x] == labels_[y]) return 0.5 * (p_[x] + p_[y]);
    const double a = std::abs(values_[x]), b = std::abs(values_[y]);
    return p_[x] + a / (a + b) * (p_[y] - p_[x]);
  }
  /// Of the edges between some corners of several labels.
  template <std::size_t N> Vec3 mean_zero(const std::array<std::size_t, N>& corners) const {
    Vec3 sum;
    double count = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i + 1; j < N; ++j) {
        if (labels_[corners[i]] == labels_[corners[j]]) continue;
        sum += end(corners[i], corners[j]);
        ++count;
      }
    return sum / count;
  }

  std::array<Vec3, 4> p_;
  std::array<double, 4> values_;
  TetLabels labels_;
};

void add_cell(const std::array<Vec3, 4>& p, int label, const SectionPlane& plane,
              std::vector<SectionGeometry::Cell>& cells) {
  std::array<double, 4> h{};
  for (std::size_t k = 0; k < 4; ++k) h[k] = plane.height(p[k]);
  if (auto cell = cut_cell(p, h, plane)) {
    cell->label = label;
    cells.push_back(*cell);
  }
}

/// Where the curves of Z cross the plane.
std::vector<SectionGeometry::Crossing> find_crossings(const ZeroSet& zero, const SectionPlane& plane) {
  std::vector<SectionGeometry::Crossing> crossings;
  const ZeroCurves curves = zero_curves(zero);
  const auto add = [&](const std::vector<ZeroCurves::Edge>& edges, bool border) {
    for (const auto& [a, b] : edges) {
      const Vec3 p = zero.vertices[a].position, q = zero.vertices[b].position;
      const double hp = plane.height(p), hq = plane.height(q);
      if ((hp >= 0) != (hq >= 0)) crossings.push_back({plane.project(p + hp / (hp - hq) * (q - p)), border});
    }
  };
  add(curves.border, true);
  add(curves.triple, false);
  return crossings;
}

} // namespace

std::vector<SectionGeometry::Segment> zero_segments(const ZeroSet& zero, const SectionPlane& plane) {
  std::vector<Segment> segments;
  for (const ZeroSet::Polygon& polygon : zero.polygons) {
    std::array<Vec3, 4> p;
    std::array<double, 4> h{};
    for (std::size_t k = 0; k < polygon.count; ++k) {
      p[k] = zero.vertices[polygon.v[k]].position;
      h[k] = plane.height(p[k]);
    }
    const std::size_t n = polygon.count;
    if (const auto segment = cut(std::span(p).first(n), std::span(h).first(n), plane))
      segments.push_back(*segment);
  }
  return segments;
}

SectionGeometry section_geometry(const StateSnapshot& state, const SectionPlane& plane,
                                 const SectionOptions& options) {
  SectionGeometry out;
  const Complex& complex = state.complex;
  std::vector<double> heights(complex.vertices.size());
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = plane.height(complex.vertices[i].position);

  const bool rooms = state.zero_set.has_rooms();
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    if (!drawn(state, i, options.box)) continue;
    const Tet& tet = complex.tets[i];
    if (tet.side != 0)
      add_cell(complex.positions(TetId(i)), tet.side, plane, out.cells);
    else if (rooms && complex.form == ZeroForm::interpolated)
      PartsByLabel(complex, TetId(i)).for_each([&](const std::array<Vec3, 4>& p, int label) {
        add_cell(p, label, plane, out.cells);
      });
    for (std::size_t facet = 0; facet < 4; ++facet) {
      const TetId other = tet.neighbor[facet];
      if (other.valid() && other.index() < i && drawn(state, other.index(), options.box)) continue;
      std::array<Vec3, 3> p;
      std::array<double, 3> h{};
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId v = tet.v[facets[facet][k]];
        p[k] = complex.position(v);
        h[k] = heights[v.index()];
      }
      if (const auto segment = cut(p, h, plane)) out.tetrahedra.push_back(*segment);
    }
  }
  out.zero_set = zero_segments(state.zero_set, plane);
  for (const DroppedFacet& f : dropped_facets(complex)) {
    std::array<Vec3, 3> p;
    std::array<double, 3> h{};
    const auto corners = complex.tet(f.tet).facet(f.facet);
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = complex.position(corners[k]);
      h[k] = heights[corners[k].index()];
    }
    if (const auto segment = cut(p, h, plane)) out.dropped.push_back(*segment);
  }
  out.crossings = find_crossings(state.zero_set, plane);
  const auto in_box = [&](VertexId v) { return complex.vertices[v.index()].kind == VertexKind::box; };
  for (const GammaFacet& facet : state.gamma) {
    if (!options.box && std::any_of(facet.v.begin(), facet.v.end(), in_box)) continue;
    std::array<Vec3, 3> p;
    std::array<double, 3> h{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = complex.position(facet.v[k]);
      h[k] = heights[facet.v[k].index()];
    }
    if (const auto segment = cut(p, h, plane)) out.gamma.push_back(*segment);
  }
  if (state.samples && options.sample_distance > 0) {
    for (std::size_t i = 0; i < state.samples->size(); ++i) {
      const Vec3 p = state.samples->positions[i];
      if (std::abs(plane.height(p)) > options.sample_distance) continue;
      const bool bad = i < state.errors.size() && is_bad(static_cast<double>(state.errors[i]));
      out.samples.push_back({plane.project(p), SampleId(i), bad, state.samples->labels[i] > 0});
    }
    for (const Vec3 p : state.samples->over_rim)
      if (std::abs(plane.height(p)) <= options.sample_distance) out.over_rim.push_back(plane.project(p));
  }
  return out;
}

std::vector<RimCrossing> rim_crossings(const Rim& rim, const SectionPlane& plane) {
  std::vector<RimCrossing> crossings;
  for (const RimPiece& p : rim.pieces()) {
    const double ha = plane.height(p.a), hb = plane.height(p.b);
    if ((ha >= 0) != (hb >= 0))
      crossings.push_back({plane.project(p.a + ha / (ha - hb) * (p.b - p.a)), p.open});
  }
  return crossings;
}

TetId section_tet(const StateSnapshot& state, const SectionPlane& plane, PlanePoint at, bool box) {
  const Vec3 p = plane.lift(at);
  const auto volume = [](Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - a), d - a); };
  for (std::size_t i = 0; i < state.complex.tets.size(); ++i) {
    if (!drawn(state, i, box)) continue;
    const std::array<Vec3, 4> q = state.complex.positions(TetId(i));
    const bool inside = volume(p, q[1], q[2], q[3]) >= 0 && volume(q[0], p, q[2], q[3]) >= 0 &&
                        volume(q[0], q[1], p, q[3]) >= 0 && volume(q[0], q[1], q[2], p) >= 0;
    if (inside) return TetId(i);
  }
  return {};
}

} // namespace isoscope
