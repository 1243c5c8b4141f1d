// What would happen if an edge were collapsed to a point that a person chose: every check, and Z before and
// after.
#pragma once

#include "collapse/collapse_margins.h"
#include "questions/edge_xray.h"

namespace isoscope {

/// A target under study.
struct TargetStudy {
  Vec3 target;
  CollapseAttempt
      attempt; ///< every check on it; `candidates` says whether it lies in the kernel, by what slack
  /// Facets of Z at the edge after the collapse; those that leave Ω or are not proven inside.
  struct Facet {
    Triangle3 corners;
    bool inside = true;
  };
  std::vector<Facet> after;
  std::vector<Triangle3> before;
  /// The numbers of the checks behind the kernel, before the collapse and after it.
  struct Change {
    CollapseCheck check = CollapseCheck::containment;
    std::optional<CheckMargin> before, after;
  };
  std::vector<Change> changes;
  /// Of the first check that fails: where, and what the number is measured to (the closest point of the
  /// input, or the sample).
  std::optional<CollapseCheck> failed;
  Vec3 witness, measured_to;
  /// Sampled mode: the tetrahedron that would hold the misclassified sample, after the collapse.
  std::optional<std::array<Vec3, 4>> tet;
};

/// Judges a target of the edge under the X-ray.
TargetStudy study_target(const EdgeXray& xray, Vec3 target, const XrayContext& context);

/// What a target being dragged may snap to.
enum class TargetSnap : std::uint8_t {
  optimum, ///< the least error without constraints
  best,    ///< the least error in the kernel
  found,   ///< what the search found; the least error in the kernel where it found nothing
  vertex,  ///< the nearest vertex of the kernel, from inside
  center,  ///< of the largest ball in the kernel
  kept,
  removed ///< the ends of the edge
};
/// Nothing where there is no such point: the kernel is empty.
std::optional<Vec3> snapped(const EdgeXray& xray, Vec3 target, TargetSnap snap);

} // namespace isoscope
