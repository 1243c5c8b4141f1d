// The view's marks and hatches in panels, in the shapes of shaders/marker.frag and shaders/hatch.glsl.
#include "scene/palette.h"
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

void room_swatch(const Ui& ui, ImVec2 low, ImVec2 high, int label) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const RoomStyle style = room_style(label);
  const auto color = [&](float strength) {
    return ImGui::ColorConvertFloat4ToU32(
        {strength * style.color.x, strength * style.color.y, strength * style.color.z, 1});
  };
  list.AddRectFilled(low, high, color(1));
  list.PushClipRect(low, high, true);
  const ImU32 ink = color(0.45f);
  const float step = ui.px(6), wide = std::max(1.0f, ui.px(1.3f)), tall = high.y - low.y;
  const bool rising = style.hatch == Hatch::rising || style.hatch == Hatch::crossed;
  const bool falling = style.hatch == Hatch::falling || style.hatch == Hatch::crossed;
  for (float x = low.x - tall; x < high.x + tall; x += step) {
    if (rising) list.AddLine({x, high.y}, {x + tall, low.y}, ink, wide);
    if (falling) list.AddLine({x, low.y}, {x + tall, high.y}, ink, wide);
    if (style.hatch == Hatch::upright) list.AddLine({x, low.y}, {x, high.y}, ink, wide);
  }
  for (float y = low.y + step / 2; y < high.y; y += step) {
    if (style.hatch == Hatch::level) list.AddLine({low.x, y}, {high.x, y}, ink, wide);
    for (float x = low.x + step / 2; x < high.x && style.hatch == Hatch::dots; x += step)
      list.AddCircleFilled({x, y}, ui.px(1.4f), ink, 8);
  }
  list.PopClipRect();
}

} // namespace isoscope::widgets
