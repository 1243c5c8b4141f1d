// Lines, marks and cells that answer a question about the state, as plain data for the renderer.
#pragma once

#include "base/geometry.h"
#include "journal/vocabulary.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isoscope {

/// What a mark means; the theme gives it a colour, its shape says the same again.
enum class Tone : std::uint8_t { good, bad, warning, accent, quiet };

struct Annotation {
  struct Line {
    Vec3 a, b;
    Tone tone = Tone::accent;
    float width = 1.5f; ///< interface pixels
    bool dashed = false;
  };
  struct Mark {
    Vec3 at;
    Tone tone = Tone::accent;
    MarkerShape shape = MarkerShape::disc;
    std::uint8_t diameter = 10; ///< interface pixels
  };
  struct Face {
    Triangle3 corners;
    Tone tone = Tone::accent;
    float opacity = 0.3f;
  };
  /// A cube of a heat map; `heat` in (0, 1] of the hottest.
  struct Cell {
    Vec3 center;
    double size = 0;
    float heat = 0;
  };
  std::vector<Line> lines;
  std::vector<Mark> marks;
  std::vector<Face> faces;
  std::vector<Cell> cells;
  bool empty() const { return lines.empty() && marks.empty() && faces.empty() && cells.empty(); }
};

/// The colours of heat 0 to 1, dark red to light yellow: brightness grows with the heat.
constexpr std::array<std::uint32_t, 4> heat_stops{0x7A1F3D, 0xC8402F, 0xF08A24, 0xFFE27A};

} // namespace isoscope
