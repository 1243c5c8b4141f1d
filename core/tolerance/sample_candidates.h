// For one octree cell: small cells that hold its part of ∂Ω', each with a point of ∂Ω' to cover it.
#pragma once

#include "tolerance/regions.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// A cube that may hold boundary points, and a boundary point that covers all of the cube, if one was found.
struct SampleCandidate {
  Vec3 center;
  double half_side = 0;
  Vec3 point;      ///< on d = δ', snapped
  Vec3 reached;    ///< where its side may be asked for when `region` is unknown and `ask_octree` is set
  RegionId region; ///< behind the point; invalid while not known
  std::uint32_t volume_component = 0;
  std::int8_t label = 0; ///< 0 with a point: over the open rim (§4.1)
  bool has_point = false;
  bool ask_octree = false;
};

struct CandidateOptions {
  double target_bound = 0;  ///< cells are split until a point covers them within this distance
  double crevice_side = 0;  ///< cells in crevices without a side are not split below this side
  double smallest_side = 0; ///< and no cell below this one
  double snap_unit = 0;
  /// Closed input: the one region of each side, when there is one only. Boundary points of opposite sides are
  /// then at least 2 δ' apart and a cell smaller than that has one side: its region holds for all of its
  /// points.
  bool one_region_a_cell = false;
};

/// The largest distance from p to a point of the cube.
double farthest_in_cube(Vec3 p, Vec3 center, double half_side);

/// A cube that may hold boundary points: an ambiguous main cell, or what repeated halving makes of one.
struct CandidateCube {
  Vec3 center;
  double side = 0;
  ClosestPoint closest; ///< of the centre
};

CandidateCube cube_of(const ToleranceVolume& volume, const Regions::Cell& main_cell);
/// Halves a cube until its parts are at most `widest` wide, and appends those that may hold boundary points,
/// in the order of find_candidates. Thread-safe.
void split_cube(const ToleranceVolume& volume, const CandidateCube& cube, double widest,
                std::vector<CandidateCube>& parts);

/// Appends the candidates of a cube, those of each of its parts of side <= target_bound together, in the
/// octree's order. Thread-safe.
void find_candidates(const ToleranceVolume& volume, const CandidateCube& cube,
                     const CandidateOptions& options, std::vector<SampleCandidate>& candidates);

} // namespace isoscope
