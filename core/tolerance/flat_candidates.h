// Candidates of samples where ∂Ω' is nearly a plane: one for a whole main cell.
#pragma once

#include "tolerance/sample_candidates.h"

#include <vector>

namespace isoscope {

/// Finds them, cell after cell; of closed triangles with one region on each side. Neighbours that follow each
/// other cost least. Not thread-safe.
class FlatCandidates {
 public:
  /// Points cover a whole cell within options.target_bound.
  FlatCandidates(const ToleranceVolume& volume, const CandidateOptions& options)
      : volume_(volume), options_(options), boundary_(volume.thresholds().boundary) {}

  /// Whether all that is near to the cell lies in one plane, nearly: then its candidate is appended, or
  /// nothing where ∂Ω' passes by.
  bool add(const CandidateCube& cell, std::vector<SampleCandidate>& candidates);

 private:
  /// The region of a ball outside of Ω', whose centre's closest point is given; invalid where it is not told.
  RegionId region_around(Vec3 center, double radius, const ClosestPoint& closest);

  const ToleranceVolume& volume_;
  const CandidateOptions& options_;
  double boundary_;
  Vec3 known_center_; ///< of a ball outside of Ω', in the known region
  double known_radius_ = 0;
  RegionId known_region_;
};

} // namespace isoscope
