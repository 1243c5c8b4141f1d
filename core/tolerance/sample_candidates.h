// For one octree cell: small cells that hold its part of ∂Ω', each with a point of ∂Ω' to cover it.
#pragma once

#include "tolerance/regions.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// A cube that may hold boundary points, and a boundary point that covers all of the cube within `bound`, if
/// one was found.
struct SampleCandidate {
  Vec3 center;
  double half_side = 0;
  Vec3 point;       ///< on d = δ', snapped
  double bound = 0; ///< largest distance from a point of the cube to `point`
  RegionId region;  ///< invalid while not known
  std::uint32_t volume_component = 0;
  bool has_point = false;
  bool ask_octree = false; ///< the region must be asked for at `reached`, refining the octree
  Vec3 reached;
};

struct CandidateOptions {
  double target_bound = 0;  ///< cells are split until their bound is this small
  double smallest_side = 0; ///< but not below this side
  double snap_unit = 0;
};

/// The largest distance from p to a point of the cube.
double farthest_in_cube(Vec3 p, Vec3 center, double half_side);

/// Appends the candidates of an ambiguous main cell, in Morton order. Thread-safe.
void find_candidates(const ToleranceVolume& volume, const Regions::Cell& cell,
                     const CandidateOptions& options, std::vector<SampleCandidate>& candidates);

} // namespace isoscope
