// The shapes of marks in the view, and of the same marks in panels.
#pragma once

#include <cstdint>

namespace isoscope {

/// The numbers are those of shaders/marker.frag; 8 more draws the outline alone.
enum class MarkerShape : std::uint8_t {
  ring,
  disc,
  cross,
  circle, ///< a thin ring
  square,
  diamond,
  triangle,
  plus,
  hollow_square = 12,
  hollow_diamond,
  hollow_triangle
};

} // namespace isoscope
