// Small pictures as PNG.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isoscope::sweep {

/// Red, green, blue, opacity.
using Rgba = std::array<std::uint8_t, 4>;

/// A picture of up to 256 colours, rows from the top.
struct IndexedPicture {
  unsigned width = 0, height = 0;
  std::vector<Rgba> palette;
  std::vector<std::uint8_t> pixels;
};

std::string png(const IndexedPicture& picture);

} // namespace isoscope::sweep
