// Bricks, and the tiles that each level and shift makes of them.
#pragma once

#include "base/geometry.h"
#include "improve/change_box.h"

#include <array>
#include <compare>
#include <cstdint>

namespace isoscope {

/// A cube of the grid, or a tile of some tiling, by its place along each axis.
using GridPlace = std::array<std::int32_t, 3>;

/// One tiling: tiles of 4 · 2^level bricks a side, moved by a quarter of that along (1, 1, 1) `shift` times.
/// Every point is at least an eighth of a tile's side from the planes of one of four tilings in a row.
struct Tiling {
  std::int32_t level = 0;
  std::int32_t shift = 0; ///< 0 to 3
  bool whole = false;     ///< one tile is all of space
  friend bool operator==(const Tiling&, const Tiling&) = default;
};
constexpr std::int32_t shifts = 4, bricks_of_tile = 4;

/// Rounded down.
constexpr std::int32_t floor_div(std::int32_t a, std::int32_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// The grid: bricks begin at multiples of their side, which is a power of two, so that each has its bounds
/// exactly.
class TileGrid {
 public:
  /// `brick`: a power of two; `box`: of all points.
  TileGrid(double brick, const Box3& box) : brick_(brick), box_(box) {}

  double brick() const { return brick_; }
  const Box3& box() const { return box_; }
  GridPlace brick_of(Vec3 p) const;
  /// The tile that holds a brick.
  GridPlace tile_of(const Tiling& tiling, const GridPlace& brick) const;
  ChangeBox bounds(const Tiling& tiling, const GridPlace& tile) const;
  /// Whether a tile of this level would hold all of the box: then one is taken that is all of space.
  bool is_whole(std::int32_t level) const;

 private:
  double brick_;
  Box3 box_;
};

/// The power of two that a brick's side is where one tile is as large as the box.
double largest_brick(const Box3& box);

} // namespace isoscope
