// Pictures of the renderer under test: pixels, comparison, reference files.
#pragma once

#include "scene/renderer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isoscope::testing {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  using Color = std::array<int, 4>;
  Color at(int x, int y) const {
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]};
  }
  /// How many pixels satisfy the predicate on a colour.
  template <class Predicate> std::size_t count(Predicate&& wanted) const {
    std::size_t n = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) n += wanted(at(x, y)) ? 1u : 0u;
    return n;
  }
};

Picture take(const Renderer& renderer, const Renderer::Frame& frame);

/// Mean absolute difference of colour channels, 0 to 255; 255 when the sizes differ.
double difference(const Picture& a, const Picture& b);

/// Compares with tests/scene/reference/NAME.png; with ISOSCOPE_UPDATE_REFERENCES set in the environment
/// writes it instead. Returns the mean difference, 255 when there is no such file. The picture is left in the
/// build folder when it differs.
double compare_with_reference(const Picture& picture, const std::string& name);

} // namespace isoscope::testing
