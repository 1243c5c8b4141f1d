// Where the bricks of a distance grid lie in their texture.
#pragma once

#include "tolerance/distance_grid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace isoscope {

/// Bricks stand above each other, in as few columns as there may be, then behind each other: so narrow that
/// the samples of one lie close together in memory, and no multiple of a power of two apart.
class BrickAtlas {
 public:
  /// Room for the bricks of a grid, and after them for two of one value each: what places without a brick
  /// show on the outer and on the inner side.
  explicit BrickAtlas(std::size_t grid_bricks)
      : bricks_(grid_bricks), columns_((count() + rows * layers - 1) / (rows * layers)) {}
  std::size_t outer() const { return bricks_; }
  std::size_t inner() const { return bricks_ + 1; }
  std::size_t count() const { return bricks_ + 2; }

  /// A brick's place among bricks: column, row, layer.
  std::array<int, 3> at(std::size_t brick) const {
    return {static_cast<int>(brick / rows % columns_), static_cast<int>(brick % rows),
            static_cast<int>(brick / (rows * columns_))};
  }
  /// The same as shaders/bricks.glsl takes it apart: 8 bits each.
  std::uint32_t packed(std::size_t brick) const {
    const std::array<int, 3> c = at(brick);
    return static_cast<std::uint32_t>(c[0] | c[1] << 8 | c[2] << 16);
  }
  /// Of the texture, in samples.
  std::array<int, 3> size() const {
    constexpr int n = DistanceGrid::samples;
    return {n * static_cast<int>(columns_), n * static_cast<int>(std::min(count(), rows)),
            n * (at(count() - 1)[2] + 1)};
  }
  /// How many bricks from this one on stand above each other.
  std::size_t run(std::size_t brick) const { return std::min(rows - brick % rows, count() - brick); }

 private:
  static constexpr std::size_t rows = 255, layers = 256, most_columns = 255;
  static_assert(DistanceGrid::most_bricks + 2 <= rows * layers * most_columns);
  std::size_t bricks_, columns_;
};

} // namespace isoscope
