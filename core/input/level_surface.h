// The surface on which a grid has some value: by marching tetrahedra, for pictures of given volumes.
#pragma once

#include "base/run_control.h"
#include "input/scalar_grid.h"
#include "input/triangle_soup.h"

namespace isoscope {

/// Adds the triangles of {g = level}, whose front is where g is larger. Cubes are cut into six tetrahedra
/// around a diagonal, so that no case is ambiguous and the surface is closed but for the border of the grid.
/// Of no use once the control is cancelled.
void add_level_surface(const ScalarGrid& grid, double level, TriangleSoup& soup, const RunControl& control);

} // namespace isoscope
