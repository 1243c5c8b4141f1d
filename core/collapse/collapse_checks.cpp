// Judges a target by samples, by the facet certificate, by condition 3 and by the regions' witnesses.
#include "collapse/collapse_checks.h"

#include "collapse/star_location.h"
#include "criteria/orientation.h"
#include "mesh/predicates.h"
#include "mesh/strata.h"
#include "mesh/zero_set.h"
#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

namespace {

/// Pieces of a facet looked at before a collapse is given up: it is only one of many.
constexpr std::size_t piece_budget = 4000;
/// A violating point that hardly depends on the target teaches nothing about it.
constexpr double least_weight = 1e-3;

/// Barycentric weight of corner k of a triangle at a point of its plane.
double weight_at(const Triangle3& t, std::size_t k, Vec3 w) {
  const Vec3 a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  const Vec3 n = cross(b - a, c - a);
  const double area = squared_length(n);
  return area > 0 ? dot(n, cross(b - w, c - w)) / area : 0;
}

/// What a facet that leaves Ω tells of other targets. Its violating point w moves with the target's weight λ:
/// to first order the target must go by (d(w) − δ)/λ towards w's closest point, and nearer than that it stays
/// out.
void learn(const ZeroFacetAfter& facet, const FacetVerdict& found, double delta, TargetVerdict& verdict) {
  if (facet.target_corner < 0 || !found.closest.triangle.valid()) return;
  const auto k = static_cast<std::size_t>(facet.target_corner);
  const double weight = weight_at(facet.corners, k, found.witness);
  const double d = found.closest.distance();
  if (weight < least_weight || !(d > 0)) return;
  const Vec3 inward = (found.closest.point - found.witness) / d;
  verdict.learnt = HalfSpace{inward, dot(inward, facet.corners[k]) + (d - delta) / weight};
  verdict.invalid = invalid_region(facet.corners[k], weight, d - delta);
}

/// Edges of the border at the ends of the edge that a collapse changes: those it takes and those it leaves,
/// the target first.
struct BorderChange {
  std::vector<Segment3> before, after;
};

BorderChange border_change(const EdgeStar& star, Vec3 target) {
  BorderChange change;
  const std::vector<StarFacet> facets = side_facets(star);
  for (std::uint16_t end = 0; end < 2; ++end) {
    const Vec3 at_end = star.vertices[end].position;
    for (const std::uint32_t other : borders_from(link_arcs(facets, end))) {
      const Vec3 p = star.vertices[other].position;
      if (other < 2 && end == 1) continue; // the edge itself, met from its other end
      change.before.push_back({at_end, p});
      if (other >= 2) change.after.push_back({target, p});
    }
  }
  return change;
}

/// What a border edge that is too far from the rim, or the rim from it, tells of other targets: the foot of
/// the gap moves with the target's weight, and must come nearer by what is too much.
TargetVerdict learn_border(const Segment3& edge, Vec3 foot, Vec3 gap, const BorderVerdict& found,
                           double delta) {
  TargetVerdict verdict = Refusal{Reason::border_distance, found.distance, delta, found.witness};
  const double weight = 1 - closest_on_segment(foot, edge), d = length(gap);
  if (weight < least_weight || !(d > 0)) return verdict;
  const Vec3 inward = gap / d;
  verdict.learnt = HalfSpace{inward, dot(inward, edge[0]) + (found.distance - delta) / weight};
  return verdict;
}

std::size_t violated_tests(const OrientationVerdict& verdict) {
  return static_cast<std::size_t>(
      std::count_if(verdict.tests.begin(), verdict.tests.end(), [](const auto& t) { return !t.good(); }));
}

/// Whether a point that is on its side stays there.
TargetVerdict keeps_side(const EdgeStar& star, Vec3 target, const Box3& box, Vec3 x, int label) {
  if (x.x < box.lo.x || x.x > box.hi.x || x.y < box.lo.y || x.y > box.hi.y || x.z < box.lo.z ||
      x.z > box.hi.z)
    return {};
  const StarLocation after = locate_after(star, target, x);
  if (after.tet == nullptr) return {};
  const double f = side_at(star, after, x, label);
  if (f > 0) return {};
  const StarLocation before = locate_before(star, x);
  const double f_before = before.tet == nullptr ? 1 : side_at(star, before, x, label);
  return f_before > 0 ? Refusal{Reason::witness_side, f, 0, x} : TargetVerdict{};
}

} // namespace

std::vector<ZeroFacetAfter> zero_facets_after(const EdgeStar& star, Vec3 target) {
  std::vector<ZeroFacetAfter> facets;
  if (star.form == ZeroForm::embedded) {
    for (const StarFacet& f : zero_facets(star)) {
      if (f.ring()) continue;
      ZeroFacetAfter& after = facets.emplace_back();
      after.labels = f.labels;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool end = f.v[k] < 2;
        after.corners[k] = end ? target : star.vertices[f.v[k]].position;
        if (end) after.target_corner = static_cast<int>(k);
      }
    }
    return facets;
  }
  std::vector<LabelledTriangle> triangles;
  for (const EdgeStar::StarTet& t : star.tets) {
    if (!t.ring())
      append_zero_triangles(star.positions_after(t, target), values_after(star, t), labels_after(star, t),
                            vertices_after(star, t), triangles);
  }
  for (const LabelledTriangle& t : triangles) facets.push_back({t.corners, -1, t.labels});
  return facets;
}

std::vector<LabelledTriangle> zero_facets_before(const EdgeStar& star) {
  std::vector<LabelledTriangle> triangles;
  if (star.form == ZeroForm::embedded) {
    for (const StarFacet& f : zero_facets(star)) {
      triangles.push_back(
          {{star.vertices[f.v[0]].position, star.vertices[f.v[1]].position, star.vertices[f.v[2]].position},
           f.labels});
    }
    return triangles;
  }
  for (const EdgeStar::StarTet& t : star.tets) {
    append_zero_triangles(star.positions(t), star.values(t), star.labels(t), star.ids(t), triangles);
  }
  return triangles;
}

TargetVerdict check_containment(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume) {
  const double delta = volume.thresholds().delta;
  const ToleranceField& field = volume.field();
  // Before it is embedded, and then cut, Z goes on beyond the rim of open surfaces.
  const PieceJudge judge = star.form == ZeroForm::interpolated ? outside_judge(volume) : PieceJudge();
  FacetSearch search;
  search.budget = piece_budget;
  if (judge) search.judge = &judge;
  if (star.vertices[0].value == 0) {
    const ClosestPoint closest = field.closest(target);
    if (closest.distance() > delta) {
      TargetVerdict verdict = Refusal{Reason::outside_tolerance, closest.distance(), delta, target};
      const Vec3 inward = normalized(closest.point - target);
      verdict.learnt = HalfSpace{inward, dot(inward, closest.point) - delta};
      verdict.invalid = invalid_region(target, 1, closest.distance() - delta);
      return verdict;
    }
  }
  for (const ZeroFacetAfter& facet : zero_facets_after(star, target)) {
    const FacetVerdict verdict = certify_facet(field, facet.corners, delta, delta, search);
    if (verdict.kind == FacetVerdict::Kind::inside) continue;
    if (verdict.kind == FacetVerdict::Kind::undecided) {
      return Refusal{Reason::unproven, verdict.closest.distance(), delta, verdict.witness};
    }
    TargetVerdict outside =
        Refusal{Reason::outside_tolerance, verdict.closest.distance(), delta, verdict.witness};
    learn(facet, verdict, delta, outside);
    return outside;
  }
  return {};
}

std::optional<TargetVerdict> check_border(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume) {
  const BorderGate* gate = volume.border_gate();
  if (gate == nullptr || star.cost_borders.empty()) return std::nullopt;
  const BorderChange change = border_change(star, target);
  if (change.before == change.after) return std::nullopt;
  for (const Segment3& edge : change.after) {
    const BorderVerdict verdict = gate->keeps_to_rim(edge);
    if (verdict.proven) continue;
    return learn_border(edge, verdict.witness, gate->rim().closest(verdict.witness).point - verdict.witness,
                        verdict, gate->delta());
  }
  std::vector<Segment3> after = change.after;
  after.insert(after.end(), star.border_beyond.begin(), star.border_beyond.end());
  const BorderVerdict verdict = gate->covers_rim(change.before, after);
  if (verdict.proven) return TargetVerdict{};
  const auto nearest =
      std::min_element(change.after.begin(), change.after.end(), [&](const Segment3& x, const Segment3& y) {
        return distance_to(x, verdict.witness) < distance_to(y, verdict.witness);
      });
  if (nearest == change.after.end())
    return Refusal{Reason::border_distance, verdict.distance, gate->delta(), verdict.witness};
  const Vec3 foot = point_on(*nearest, closest_on_segment(verdict.witness, *nearest));
  return learn_border(*nearest, foot, verdict.witness - foot, verdict, gate->delta());
}

TargetVerdict check_normals(const EdgeStar& star, Vec3 target, const EvaluationContext& context) {
  if (context.nearest == nullptr || !context.nearest->has(+1) || !context.nearest->has(-1)) return {};
  const double shrink = context.criteria.shrink;
  const double reach = orientation_reach * context.criteria.delta;
  std::size_t before = 0, after = 0;
  Refusal verdict;
  const auto note_worst = [&](double agreement, Vec3 at) {
    if (verdict.reason != Reason::none && agreement >= verdict.value) return;
    verdict = {Reason::normals, agreement, 0, at};
  };
  if (star.form == ZeroForm::embedded) {
    const auto count = [&](const Triangle3& t, LabelPair labels, bool note) {
      std::size_t violated = 0;
      for (const FacetOrientationTest& test :
           check_facet_orientation(t, shrink, reach, *context.nearest, labels)) {
        if (test.good()) continue;
        ++violated;
        if (note) note_worst(test.agreement, test.shrunk);
      }
      return violated;
    };
    for (const ZeroFacetAfter& f : zero_facets_after(star, target)) after += count(f.corners, f.labels, true);
    if (after > 0) {
      for (const LabelledTriangle& t : zero_facets_before(star)) before += count(t.corners, t.labels, false);
    }
  } else {
    const auto count = [&](const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                           const TetLabels& labels, bool note) -> std::size_t {
      if (label_count(labels) < 2) return 0;
      const OrientationVerdict v = check_orientation(p, f, labels, shrink, reach, *context.nearest);
      if (note && v.misoriented) {
        const OrientationTest& worst = v.tests[static_cast<std::size_t>(v.worst)];
        note_worst(worst.f, worst.shrunk);
      }
      return violated_tests(v);
    };
    for (const EdgeStar::StarTet& t : star.tets) {
      if (!t.ring())
        after += count(star.positions_after(t, target), values_after(star, t), labels_after(star, t), true);
    }
    if (after > 0) {
      for (const EdgeStar::StarTet& t : star.tets)
        before += count(star.positions(t), star.values(t), star.labels(t), false);
    }
  }
  return after > before ? verdict : TargetVerdict{};
}

TargetVerdict check_witnesses(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume) {
  Box3 box;
  for (const auto& v : star.vertices) box.add(v.position);
  for (const Witness& witness : volume.witnesses())
    if (const TargetVerdict verdict = keeps_side(star, target, box, witness.point, witness.label);
        verdict.reason != Reason::none)
      return verdict;
  // What Z keeps of the rim once it has been cut, its border keeps.
  if (star.form != ZeroForm::interpolated || volume.border_gate() == nullptr) return {};
  const SegmentIndex& crossed = volume.border_gate()->crossed();
  for (const std::uint32_t i : crossed.near(box.center(), 0.5 * length(box.extent())))
    for (const std::size_t end : {0, 1})
      if (const TargetVerdict verdict =
              keeps_side(star, target, box, crossed.segments()[i][end], end == 0 ? -1 : +1);
          verdict.reason != Reason::none)
        return verdict;
  return {};
}

} // namespace isoscope
