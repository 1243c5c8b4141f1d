// Cells of a lattice of cubes, as what groups places of the input that are near to each other.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace isoscope {

using LatticeCell = std::array<std::int64_t, 3>;

/// The cell that holds p, of cubes of this side (> 0) from `origin` on in all directions.
inline LatticeCell lattice_cell(Vec3 p, Vec3 origin, double side) {
  LatticeCell cell{};
  for (int k = 0; k < 3; ++k)
    cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor((p[k] - origin[k]) / side));
  return cell;
}

} // namespace isoscope
