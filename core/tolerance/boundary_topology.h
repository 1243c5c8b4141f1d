// The Euler characteristic of each boundary component of Ω'.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/tolerance_volume.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace isoscope {

/// What the surface that marching tetrahedra make of the signs of d - δ' has of a boundary component.
struct BoundaryCount {
  long euler_characteristic = 0;
  std::size_t pieces = 0; ///< connected ones, where they were counted: a boundary component is one
  friend bool operator==(const BoundaryCount&, const BoundaryCount&) = default;
};

/// How boundaries are counted.
struct BoundaryCounting {
  unsigned halvings = 0; ///< how often the lattice is finer than the octree's main cells
  /// Counts pieces too, and tells what the octree's cells are too coarse for by its side: takes twice as
  /// long.
  bool careful = false;
};

/// Of each of volume.boundary_components(). Corners whose region cannot be told count as part of Ω'. Fails
/// with cancelled, and with unsupported where a careful count would take too much memory.
Result<std::vector<BoundaryCount>>
count_boundaries(const ToleranceVolume& volume, const BoundaryCounting& counting, const RunControl& control);

/// The same for surfaces in Ω', the boundaries of sets around all that is outside of Ω', each in the next
/// one, the last of which has no point nearer to the input than δ' - reach. Pieces are counted too.
struct OffsetCounting {
  unsigned halvings = 0; ///< how often the lattice is finer than the octree's main cells
  double reach = 0;      ///< below δ'
  unsigned sets = 1;
  /// The first set that a point belongs to, if it does to any; with a guess at what of the input is nearest.
  std::function<std::optional<unsigned>(Vec3, TriangleId)> first_set;
  /// Whether the boundary of a set may be so near to a point.
  std::function<bool(Vec3, double)> near;
};
Result<std::vector<BoundaryCount>> count_offsets(const ToleranceVolume& volume,
                                                 const OffsetCounting& counting, const RunControl& control);

} // namespace isoscope
