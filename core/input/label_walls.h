// The walls between all labels of a segmentation, as a surface.
#pragma once

#include "base/status.h"
#include "input/scalar_grid.h"
#include "input/triangle_soup.h"

namespace isoscope {

/// The squares between voxels of different labels, each as two triangles. A voxel is the box around its
/// point; beyond the grid all is 0, the outside. Fails with bad_input where all voxels are 0.
Result<TriangleSoup> walls_between_labels(const ScalarGrid& labels);

} // namespace isoscope
