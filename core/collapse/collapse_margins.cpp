// Each number is gathered over the whole star.
#include "collapse/collapse_margins.h"

#include "collapse/star_location.h"
#include "criteria/orientation.h"
#include "mesh/zero_set.h"

namespace isoscope {

namespace {

std::vector<LabelledTriangle> facets_of(const EdgeStar& star, const std::optional<Vec3>& target) {
  if (!target) return zero_facets_before(star);
  std::vector<LabelledTriangle> facets;
  for (const ZeroFacetAfter& f : zero_facets_after(star, *target)) facets.push_back({f.corners, f.labels});
  return facets;
}

/// f of the tetrahedra at one of the two moments.
struct Moment {
  const EdgeStar& star;
  const std::optional<Vec3>& target;

  StarLocation locate(Vec3 x) const {
    return target ? locate_after(star, *target, x) : locate_before(star, x);
  }
  std::array<double, 4> values(const EdgeStar::StarTet& t) const {
    return target ? values_after(star, t) : star.values(t);
  }
  TetLabels labels(const EdgeStar::StarTet& t) const {
    return target ? labels_after(star, t) : star.labels(t);
  }
  bool has(const EdgeStar::StarTet& t) const { return !target || !t.ring(); }
  std::array<Vec3, 4> positions(const EdgeStar::StarTet& t) const {
    return target ? star.positions_after(t, *target) : star.positions(t);
  }
};

std::optional<CheckMargin> classification(const Moment& moment, const CriteriaParameters& criteria) {
  std::optional<CheckMargin> worst;
  const double limit = moment.star.form == ZeroForm::embedded ? 1.0 : criteria.error_limit();
  for (const EdgeStar::StarSample& s : moment.star.samples) {
    const StarLocation at = moment.locate(s.position);
    if (at.tet == nullptr) continue;
    const double error = sample_error_at(moment.star, at, s.position, s.label);
    if (!worst || error > worst->value) worst = CheckMargin{error, limit, s.position, s.id};
  }
  return worst;
}

std::optional<CheckMargin> containment(const Moment& moment, const ToleranceVolume& volume) {
  std::optional<CheckMargin> worst;
  for (const LabelledTriangle& facet : facets_of(moment.star, moment.target)) {
    const CheckMargin here = largest_distance(facet.corners, volume);
    if (!worst || here.value > worst->value) worst = here;
  }
  return worst;
}

std::optional<CheckMargin> normals(const Moment& moment, const EvaluationContext& context) {
  if (context.nearest == nullptr || !context.nearest->has(+1) || !context.nearest->has(-1))
    return std::nullopt;
  const double shrink = context.criteria.shrink, reach = orientation_reach * context.criteria.delta;
  std::optional<CheckMargin> worst;
  const auto note = [&](double agreement, Vec3 at, SampleId sample) {
    if (sample.valid() && (!worst || agreement < worst->value)) worst = CheckMargin{agreement, 0, at, sample};
  };
  if (moment.star.form == ZeroForm::embedded) {
    for (const auto& [facet, labels] : facets_of(moment.star, moment.target))
      for (const FacetOrientationTest& t :
           check_facet_orientation(facet, shrink, reach, *context.nearest, labels))
        note(t.agreement, t.shrunk, t.sample);
    return worst;
  }
  for (const EdgeStar::StarTet& t : moment.star.tets) {
    if (!moment.has(t)) continue;
    const TetLabels labels = moment.labels(t);
    if (label_count(labels) < 2) continue;
    const OrientationVerdict verdict =
        check_orientation(moment.positions(t), moment.values(t), labels, shrink, reach, *context.nearest);
    for (const OrientationTest& test : verdict.tests) note(test.f, test.shrunk, test.sample);
  }
  return worst;
}

std::optional<CheckMargin> witness(const Moment& moment, const ToleranceVolume& volume) {
  std::optional<CheckMargin> worst;
  Box3 box;
  for (const auto& v : moment.star.vertices) box.add(v.position);
  for (const Witness& w : volume.witnesses()) {
    const Vec3 x = w.point;
    if (x.x < box.lo.x || x.x > box.hi.x || x.y < box.lo.y || x.y > box.hi.y || x.z < box.lo.z ||
        x.z > box.hi.z)
      continue;
    const StarLocation at = moment.locate(x);
    if (at.tet == nullptr) continue;
    const double value = side_at(moment.star, at, x, w.label);
    if (!worst || value < worst->value) worst = CheckMargin{value, 0, x, {}};
  }
  return worst;
}

} // namespace

CheckMargin largest_distance(const Triangle3& facet, const ToleranceVolume& volume) {
  constexpr int parts = 6;
  CheckMargin worst{-1, volume.thresholds().delta, {}, {}};
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) {
      const double u = static_cast<double>(i) / parts, v = static_cast<double>(j) / parts;
      const Vec3 x = (1 - u - v) * facet[0] + u * facet[1] + v * facet[2];
      const double d = volume.field().closest(x).distance();
      if (d > worst.value) worst.value = d, worst.at = x;
    }
  return worst;
}

std::optional<CheckMargin> check_margin(CollapseCheck check, const EdgeStar& star,
                                        const std::optional<Vec3>& target, const EvaluationContext& context) {
  const Moment moment{star, target};
  switch (check) {
  case CollapseCheck::classification:
    if (context.criteria.certified) return std::nullopt;
    return classification(moment, context.criteria);
  case CollapseCheck::containment:
    if (!context.criteria.certified) return std::nullopt;
    return containment(moment, context.volume);
  case CollapseCheck::normals:
    if (!context.criteria.condition_3) return std::nullopt;
    return normals(moment, context);
  case CollapseCheck::witness:
    return witness(moment, context.volume);
  default:
    return std::nullopt;
  }
}

} // namespace isoscope
