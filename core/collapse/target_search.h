// Where to put the target of a collapse: strategies over a kernel, each asking the same judge (§2.4.1,
// §2.4.3, Figures 8, 9, 11, 12).
#pragma once

#include "collapse/collapse_attempt.h"
#include "criteria/collapse_cost.h"
#include "criteria/invalid_region.h"
#include "criteria/kernel.h"
#include "journal/event.h"
#include "journal/refusal.h"
#include "mesh/edge_star.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// Which strategy looks for targets inside a kernel; each includes those before it, but for the octree.
enum class TargetStrategy : std::uint8_t {
  optimum,     ///< the least error in the kernel, nothing else
  constraints, ///< and again under half-spaces learnt from what failed
  sampling,    ///< and points drawn inside the kernel (the default)
  octree       ///< the paper's: an octree over the kernel, cells inside Ψ left out
};

/// What the judge says of a point: the checks that depend on where it lies.
struct TargetVerdict : Refusal {
  TargetVerdict() = default;
  TargetVerdict(const Refusal& refusal) : Refusal(refusal) {}
  /// A half-space that the target must lie in to avoid this failure, to first order.
  std::optional<HalfSpace> learnt;
  /// Targets that fail for the same reason: they are not asked for again.
  std::optional<InvalidRegion> invalid;
};
using TargetJudge = std::function<TargetVerdict(Vec3)>;

/// Limits of a search.
struct TargetSearchOptions {
  TargetStrategy strategy = TargetStrategy::sampling;
  int constraint_rounds = 10; ///< of lazy constraints
  int kernel_samples = 100;   ///< points drawn; also how many of given points are judged at most
  int octree_depth = 5;       ///< of the octree over the kernel's box
  int octree_samples = 200;   ///< centres of cells judged at most
  bool record = false;        ///< keep every candidate
};

struct TargetSearchResult {
  std::optional<Vec3> target;
  double cost = 0;
  Reason found_by = Reason::none;
  /// Why the candidate of least error failed, when there is no target: kernel_empty or no_candidate where
  /// none was judged.
  TargetVerdict last_rejection;
  Vec3 rejected_point; ///< that candidate, when one was judged
  std::uint32_t tried = 0;
  // When recorded.
  std::vector<CandidateRecord> candidates;
  std::vector<OctreeCell> cells;
  std::vector<InvalidRegion> invalid_regions;
};

/// Looks for a target anywhere in the kernel (edges of Z and mixed edges). Every point that is judged lies
/// strictly inside the kernel, exactly. The same result for the same arguments: points are drawn from the ids
/// of the edge's ends.
TargetSearchResult search_kernel(const EdgeStar& star, const Kernel& kernel, const CollapseCost& cost,
                                 const TargetJudge& judge, const TargetSearchOptions& options);
/// Looks among given points: the ends of the edge (halfedge collapses) or samples of S (∂Γ, Figure 8), those
/// in the kernel by ascending cost.
TargetSearchResult search_candidates(const EdgeStar& star, const Kernel& kernel, const CollapseCost& cost,
                                     std::span<const Vec3> points, Reason found_by, const TargetJudge& judge,
                                     const TargetSearchOptions& options);

} // namespace isoscope
