// The checks of a collapse that depend on where the target lies: pure functions of a star and a point.
#pragma once

#include "collapse/target_search.h"
#include "criteria/nearest_sample.h"
#include "journal/journal.h"
#include "mesh/edge_star.h"
#include "mesh/junction.h"
#include "tolerance/tolerance_volume.h"

#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// What every evaluation of a run shares; all of it immutable while it lasts.
struct EvaluationContext {
  const ToleranceVolume& volume;
  const NearestSample* nearest = nullptr; ///< for condition 3; null: not judged
  CriteriaParameters criteria;
};

/// Corner triangles of Z that the star has at its ends' vertices, after the collapse (embedded: facets;
/// interpolated: zero polygons), with the local numbers of embedded facets.
struct ZeroFacetAfter {
  Triangle3 corners;
  int target_corner = -1; ///< which corner is the target; -1: none (interpolated)
  LabelPair labels{+1, -1};
};
std::vector<ZeroFacetAfter> zero_facets_after(const EdgeStar& star, Vec3 target);
/// The same before the collapse.
std::vector<LabelledTriangle> zero_facets_before(const EdgeStar& star);

/// Certified mode: every changed facet of Z proven inside Ω (core/README.md, N4).
TargetVerdict check_containment(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume);
/// Border edges of Z that the collapse changes are proven within δ of the rim, and what those before covered
/// of the rim stays covered (§4.1). Null where no border edge changes.
std::optional<TargetVerdict> check_border(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume);
/// Condition 3 is violated by no more tests than before (§2.4).
TargetVerdict check_normals(const EdgeStar& star, Vec3 target, const EvaluationContext& context);
/// The deepest point of every region inside the star keeps its side, and until Z is embedded what it passes
/// between before the open rim.
TargetVerdict check_witnesses(const EdgeStar& star, Vec3 target, const ToleranceVolume& volume);

} // namespace isoscope
