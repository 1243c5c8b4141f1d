// How close a collapse comes to the limits of its checks, and how close Z was before: numbers for a person,
// where the checks stop at the first violation.
#pragma once

#include "collapse/collapse_attempt.h"
#include "collapse/collapse_checks.h"

#include <optional>

namespace isoscope {

/// The number of a check that comes nearest to its limit, or exceeds it the most, and where.
struct CheckMargin {
  double value = 0, limit = 0;
  Vec3 at;
  SampleId sample; ///< classification: the sample; normals: the nearest sample that was asked
};

/// Of the star with the edge collapsed to `target`; without a target of the star as it is.
///  - classification: the largest ε over the samples, against 1 − α, or 1 once Z is embedded;
///  - containment: the largest d met at evenly spread points of the facets of Z at the ends, against δ: a
///    lower bound of the true one, which the certificate proves below δ or not;
///  - normals: the least agreement of a test of condition 3, against 0;
///  - witness: the least f·label at a region's deepest point inside the star, against 0.
/// Nothing for other checks, and where nothing is asked.
std::optional<CheckMargin> check_margin(CollapseCheck check, const EdgeStar& star,
                                        const std::optional<Vec3>& target, const EvaluationContext& context);

/// The largest d met at evenly spread points of a triangle.
CheckMargin largest_distance(const Triangle3& facet, const ToleranceVolume& volume);

} // namespace isoscope
