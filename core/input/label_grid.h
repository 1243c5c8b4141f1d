// A segmentation as a volume: how far each voxel is from the boundary of one of its labels.
#pragma once

#include "base/run_control.h"
#include "base/status.h"
#include "input/scalar_grid.h"

namespace isoscope {

/// Levels between which a boundary lies that has all voxels of the label on one side and all others on the
/// other, in voxels.
constexpr double label_level = 0.49;

/// The signed distance, in lengths of the shortest side of a voxel, from each voxel to the nearest one on the
/// other side, less half of one: at most -0.5 in the label, at least 0.5 elsewhere. Fails with bad_input
/// where no voxel or every voxel has the label.
Result<ScalarGrid> label_distance(const ScalarGrid& labels, double label, const RunControl& control);

} // namespace isoscope
