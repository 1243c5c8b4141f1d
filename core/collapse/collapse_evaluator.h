// One pure function from the star of an edge to the verdict on collapsing it: the algorithm, the window's
// what-if and the tests all ask it (core/README.md, D2).
#pragma once

#include "collapse/collapse_attempt.h"
#include "collapse/collapse_checks.h"
#include "collapse/target_search.h"

#include <optional>
#include <span>

namespace isoscope {

/// How a stage collapses its edges.
struct CollapseSettings {
  EdgeKind kind = EdgeKind::zero; ///< what is eligible; a general mixed stage takes edges of Z too
  /// The target is one of the ends (§2.4: always before the general collapse), of a mixed edge the one on Z.
  bool halfedge = false;
  TargetSearchOptions search;
};

/// Judges the collapse of the star's edge. `samples` are the candidate targets of general ∂Γ collapses, those
/// of S near the star; others ignore them. Pure: the same star gives the same verdict.
CollapseAttempt evaluate_collapse(const EdgeStar& star, const CollapseSettings& settings,
                                  const EvaluationContext& context, EvaluationDetail detail,
                                  std::span<const Vec3> samples = {});

/// The same for a target that somebody chose: every check on it, candidates are not searched.
CollapseAttempt evaluate_target(const EdgeStar& star, Vec3 target, const CollapseSettings& settings,
                                const EvaluationContext& context);

/// The error by which stages order their edges: the least that `settings` could reach without any check but
/// the edge's kind; infinite where the edge is not eligible.
double collapse_priority(const EdgeStar& star, const CollapseSettings& settings);

} // namespace isoscope
