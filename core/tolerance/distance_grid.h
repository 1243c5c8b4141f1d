// The field on a regular grid: the 3D texture from which the viewer renders Ω.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "tolerance/field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// values[(z * size[1] + y) * size[0] + x] = φ / δ at the centre of voxel (x, y, z), clamped to `clamp`.
struct DistanceGrid {
  Box3 box;
  std::array<int, 3> size{0, 0, 0};
  std::vector<float> values;
  float clamp = 4;
  /// Side of each voxel's centre, +1 towards the outer boundary and -1 towards the inner; empty when not
  /// known.
  std::vector<std::int8_t> sides;
};

/// A grid over the field's box grown by so many δ, with the longest side of `resolution` voxels. Exact at
/// every voxel centre with φ < clamp δ.
Result<DistanceGrid> make_distance_grid(const ToleranceField& field, double delta, int resolution,
                                        const RunControl& control, double margin = 2);

} // namespace isoscope
