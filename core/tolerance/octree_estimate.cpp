// Counts the layers of cells along the two sides of a plane.
#include "tolerance/octree_estimate.h"

#include "tolerance/regions.h"

#include <cmath>

namespace isoscope {
namespace {

constexpr double most_fine_cells = 3e7, fine_cells_by_area = 40;
/// Cells for each δ'² of the input with main cells of δ'/2 and of δ': cells are split whose centres are at
/// most half a diagonal away from ∂Ω', on all levels.
constexpr double cells_by_area_fine = 34, cells_by_area_coarse = 6.7;
/// Bytes that the sparsest samples of both sides take for each δ'² of the input (sample_estimate.cpp).
constexpr double sample_bytes_by_area = 500;

double cells_by_area(double ratio) {
  return ratio < 1 ? cells_by_area_fine : cells_by_area_coarse;
}

} // namespace

double OctreeEstimate::main_side_ratio(double boundary) const {
  if (!sides_known_) return 0.5;
  return fine_cells_by_area * area_ > most_fine_cells * boundary * boundary ? 1 : 0.5;
}

double OctreeEstimate::cells(double boundary) const {
  return cells_by_area(main_side_ratio(boundary)) * area_ / (boundary * boundary);
}

double OctreeEstimate::fitting_boundary(double most_bytes) const {
  const auto least = [&](double ratio) {
    const double bytes = cells_by_area(ratio) * Regions::bytes_of_cell + sample_bytes_by_area;
    return std::sqrt(bytes * area_ / most_bytes);
  };
  const double coarse = least(1);
  return main_side_ratio(coarse) == 1 ? coarse : least(0.5);
}

} // namespace isoscope
