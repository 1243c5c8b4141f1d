// Averages cells, then regions of cells.
#include "app/picture_regions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isoscope::test {
namespace {

constexpr int cell = 8, region_width = 6, region_height = 3;

/// Mean over the channels of the absolute difference of the cell's averages.
double cell_difference(const Image& a, const Image& b, int x, int y) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    int difference = 0;
    for (int j = 0; j < cell; ++j)
      for (int i = 0; i < cell; ++i) {
        const auto at = static_cast<std::size_t>(((y * cell + j) * a.width + x * cell + i) * 4 + c);
        difference += a.pixels[at] - b.pixels[at];
      }
    sum += std::abs(difference) / (255.0 * cell * cell);
  }
  return sum / 3;
}

} // namespace

PictureDifference compare_regions(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.width < cell || a.height < cell) return {};
  const int columns = a.width / cell, rows = a.height / cell;
  std::vector<double> cells;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) cells.push_back(cell_difference(a, b, x, y));
  PictureDifference found{0, 0};
  for (const double d : cells) found.mean += d / static_cast<double>(cells.size());
  // Regions overlap by a cell at least, so that what is small lies well inside of one.
  for (int y = 0; y + region_height <= rows; ++y)
    for (int x = 0; x + region_width <= columns; ++x) {
      double sum = 0;
      for (int j = 0; j < region_height; ++j)
        for (int i = 0; i < region_width; ++i)
          sum += cells[static_cast<std::size_t>((y + j) * columns + x + i)];
      const double mean = sum / (region_width * region_height);
      if (mean > found.worst) found = {found.mean, mean, x * cell, y * cell};
    }
  return found;
}

} // namespace isoscope::test
