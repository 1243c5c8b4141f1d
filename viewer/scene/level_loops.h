// Closed level curves of values on a planar lattice.
#pragma once

#include "scene/section_geometry.h"

#include <span>
#include <vector>

namespace isoscope {

/// Values at the points (x, y) of a lattice, index y * columns + x.
struct Lattice {
  PlanePoint origin;  ///< of the value (0, 0)
  double spacing = 1; ///< between neighbours, scene units
  int columns = 0, rows = 0;
  std::vector<float> values;
};

/// The curves on which the lattice takes `level`, linear between neighbours, what is below on their left. All
/// close when the outermost values are above the level; a curve that runs into the rim is left out.
std::vector<std::vector<PlanePoint>> level_loops(const Lattice& lattice, float level);

} // namespace isoscope
