// Numbers on a regular, axis-aligned grid of points: what a scan of a volume is.
#pragma once

#include "base/geometry.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace isoscope {

/// values[(z * size[1] + y) * size[0] + x] at origin + (x, y, z) * spacing; at least 2 points along each
/// axis, all finite. Kept as floats, whatever a file has: half the memory, and more digits than a scanner
/// measures.
struct ScalarGrid {
  std::array<std::size_t, 3> size{};
  Vec3 origin;
  Vec3 spacing{1, 1, 1}; ///< positive
  std::vector<float> values;
  std::string name; ///< what to call it: a file's stem

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * size[1] + y) * size[0] + x;
  }
  float at(std::size_t x, std::size_t y, std::size_t z) const { return values[index(x, y, z)]; }
  Vec3 point(std::size_t x, std::size_t y, std::size_t z) const {
    return {origin.x + static_cast<double>(x) * spacing.x, origin.y + static_cast<double>(y) * spacing.y,
            origin.z + static_cast<double>(z) * spacing.z};
  }
  Box3 box() const { return {origin, point(size[0] - 1, size[1] - 1, size[2] - 1)}; }
};

} // namespace isoscope
