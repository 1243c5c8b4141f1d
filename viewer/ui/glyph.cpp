// The view's marks in panels, in the shapes of shaders/marker.frag.
#include "ui/widgets.h"

#include <array>

namespace isoscope::widgets {

void glyph(const Ui& ui, ImVec2 middle, float radius, Rgb color, MarkerShape shape) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 c = to_u32(color);
  const float r = radius * ui.scale, stroke = std::max(1.0f, 1.4f * ui.scale);
  const auto at = [&](float x, float y) { return ImVec2{middle.x + x * r, middle.y + y * r}; };
  const auto closed = [&](const auto& points, bool hollow) {
    if (hollow)
      list.AddPolyline(points.data(), static_cast<int>(points.size()), c, ImDrawFlags_Closed, stroke);
    else
      list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), c);
  };
  switch (shape) {
  case MarkerShape::disc:
    list.AddCircleFilled(middle, r, c, 20);
    break;
  case MarkerShape::ring:
    list.AddCircle(middle, r - stroke / 2, c, 20, 1.5f * stroke);
    break;
  case MarkerShape::circle:
    list.AddCircle(middle, r - stroke / 2, c, 20, stroke);
    break;
  case MarkerShape::cross:
    list.AddLine(at(-0.8f, -0.8f), at(0.8f, 0.8f), c, 1.4f * stroke);
    list.AddLine(at(-0.8f, 0.8f), at(0.8f, -0.8f), c, 1.4f * stroke);
    break;
  case MarkerShape::plus:
    list.AddLine(at(-1, 0), at(1, 0), c, 1.4f * stroke);
    list.AddLine(at(0, -1), at(0, 1), c, 1.4f * stroke);
    break;
  case MarkerShape::square:
  case MarkerShape::hollow_square:
    closed(std::array{at(-0.8f, -0.8f), at(0.8f, -0.8f), at(0.8f, 0.8f), at(-0.8f, 0.8f)},
           shape == MarkerShape::hollow_square);
    break;
  case MarkerShape::diamond:
  case MarkerShape::hollow_diamond:
    closed(std::array{at(0, -1), at(1, 0), at(0, 1), at(-1, 0)}, shape == MarkerShape::hollow_diamond);
    break;
  case MarkerShape::triangle:
  case MarkerShape::hollow_triangle:
    closed(std::array{at(0, -1), at(0.9f, 0.7f), at(-0.9f, 0.7f)}, shape == MarkerShape::hollow_triangle);
    break;
  }
}

} // namespace isoscope::widgets
