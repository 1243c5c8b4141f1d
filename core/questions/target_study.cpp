// The evaluator's verdict on one target, with the numbers of the moment before.
#include "questions/target_study.h"

#include "collapse/star_location.h"
#include "criteria/collapse_cost.h"
#include "tolerance/facet_certificate.h"

#include <algorithm>

namespace isoscope {

namespace {

constexpr std::array<CollapseCheck, 4> measured_checks{CollapseCheck::classification,
                                                       CollapseCheck::containment, CollapseCheck::witness,
                                                       CollapseCheck::normals};
/// From a kernel's vertex towards its centre: on the boundary itself T would be flat.
constexpr double inward = 1e-3;

std::optional<CollapseCheck> first_failed_behind_kernel(const CollapseAttempt& attempt) {
  for (const CollapseCheck check : measured_checks)
    if (attempt.check(check).state == CheckVerdict::State::failed) return check;
  return std::nullopt;
}

} // namespace

TargetStudy study_target(const EdgeXray& xray, Vec3 target, const XrayContext& context) {
  const ToleranceVolume& volume = *context.scene.volume;
  const EvaluationContext evaluation{volume, context.nearest, xray.criteria};
  TargetStudy study;
  study.target = target;
  study.attempt = evaluate_target(xray.star, target, xray.settings, evaluation);
  if (!study.attempt.kernel) return study;
  for (const LabelledTriangle& t : zero_facets_before(xray.star)) study.before.push_back(t.corners);
  const double delta = volume.thresholds().delta;
  for (const ZeroFacetAfter& f : zero_facets_after(xray.star, target)) {
    constexpr std::size_t budget = 4000;
    const bool inside =
        !xray.criteria.certified ||
        certify_facet(volume.field(), f.corners, delta, delta, budget).kind == FacetVerdict::Kind::inside;
    study.after.push_back({f.corners, inside});
  }
  const bool in_kernel = study.attempt.check(CollapseCheck::candidates).state == CheckVerdict::State::passed;
  for (const CollapseCheck check : measured_checks) {
    if (study.attempt.check(check).state == CheckVerdict::State::skipped) continue;
    TargetStudy::Change change{check, check_margin(check, xray.star, std::nullopt, evaluation),
                               check_margin(check, xray.star, target, evaluation)};
    if (change.before || change.after) study.changes.push_back(change);
  }
  study.failed = first_failed_behind_kernel(study.attempt);
  if (!study.failed) return study;
  const CheckVerdict& verdict = study.attempt.check(*study.failed);
  study.witness = verdict.witness;
  study.measured_to = verdict.witness;
  if (*study.failed == CollapseCheck::containment) {
    study.measured_to = volume.field().closest(verdict.witness).point;
  } else if (*study.failed == CollapseCheck::classification && in_kernel) {
    if (const StarLocation at = locate_after(xray.star, target, verdict.witness); at.tet != nullptr)
      study.tet = at.corners;
  }
  return study;
}

std::optional<Vec3> snapped(const EdgeXray& xray, Vec3 target, TargetSnap snap) {
  const CollapseAttempt& attempt = xray.attempt;
  if (snap == TargetSnap::kept) return xray.star.vertices[0].position;
  if (snap == TargetSnap::removed) return xray.star.vertices[1].position;
  if (!attempt.kernel) return std::nullopt;
  const CollapseCost cost(xray.star);
  if (snap == TargetSnap::optimum) return cost.optimum();
  if (snap == TargetSnap::center) return attempt.kernel->center;
  if (attempt.kernel->empty) return std::nullopt;
  if (snap == TargetSnap::found && attempt.possible()) return attempt.target;
  if (snap == TargetSnap::vertex) {
    if (xray.kernel.vertices.empty()) return std::nullopt;
    const Vec3 v =
        *std::min_element(xray.kernel.vertices.begin(), xray.kernel.vertices.end(),
                          [&](Vec3 x, Vec3 y) { return distance(x, target) < distance(y, target); });
    return v + inward * (attempt.kernel->center - v);
  }
  std::vector<HalfSpace> inner = attempt.kernel->half_spaces;
  for (HalfSpace& h : inner) h.offset += inward * attempt.kernel->inscribed_radius;
  return cost.minimum(inner);
}

} // namespace isoscope
