// What the values of a grid are between in a box: exactly in a few cells, by a pyramid of blocks in many.
#pragma once

#include "base/run_control.h"
#include "input/scalar_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoscope {

/// Least and largest of some values.
struct ValueRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void add(double v) {
    least = std::min(least, v);
    most = std::max(most, v);
  }
  void add(const ValueRange& r) {
    least = std::min(least, r.least);
    most = std::max(most, r.most);
  }
  bool meets(double low, double high) const { return least <= high && most >= low; }
};

/// A cell of a grid: its point with the least coordinates.
using GridCell = std::array<std::size_t, 3>;

/// Where a point lies in a cell, each coordinate in [0, 1].
struct CellPosition {
  GridCell cell{};
  Vec3 at;
};

/// The trilinear function of a grid, continued by the value of the nearest point of the grid's box. The grid
/// outlives it. Const and thread-safe.
class TrilinearFunction {
 public:
  explicit TrilinearFunction(const ScalarGrid& grid) : grid_(&grid), box_(grid.box()) {}
  const ScalarGrid& grid() const { return *grid_; }
  const Box3& box() const { return box_; }

  CellPosition locate(Vec3 p) const;
  double value(const CellPosition& p) const;
  double value(Vec3 p) const { return value(locate(p)); }
  /// The gradient in the cell of a position, in units of space.
  Vec3 gradient(const CellPosition& p) const;
  /// The values at the eight corners of a cell, which its function is between.
  ValueRange range(const GridCell& cell) const;
  /// Upper bound of the length of the gradient in a cell.
  double steepest(const GridCell& cell) const;

 private:
  /// The derivative along an axis, at a position on the other two.
  double slope(const CellPosition& p, std::size_t axis) const;

  const ScalarGrid* grid_;
  Box3 box_;
};

/// Ranges of boxes.
class ValuePyramid {
 public:
  ValuePyramid(const TrilinearFunction& function, const RunControl& control);
  /// Contains the values in the box. In at most `most_exact_cells` cells it is what they are: a trilinear
  /// function has its extremes in a box at the box's corners.
  ValueRange range(const Box3& box) const;
  /// First and last cell that a box meets along each axis.
  std::array<GridCell, 2> cells(const Box3& box) const;
  std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t most_exact_cells = 27;
  struct Level {
    std::array<std::size_t, 3> size{};
    std::vector<float> least, most;
  };
  ValueRange exact_range(const Box3& box, const std::array<GridCell, 2>& cells) const;

  const TrilinearFunction* function_;
  std::vector<Level> levels_; ///< of blocks of 2, 4, 8, ... cells along each axis
};

} // namespace isoscope
