// Sliders with their number in the field.
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace isoscope::widgets {

bool slider(const Ui& ui, const char* id, float& value, float low, float high, const char* format,
            bool logarithmic) {
  ImGui::PushFont(ui.fonts.mono);
  ImGui::SetNextItemWidth(-1);
  const bool changed =
      ImGui::SliderFloat(id, &value, low, high, format,
                         ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
  ImGui::PopFont();
  return changed;
}

bool numbered_slider(const Ui& ui, const char* id, float& value, float low, float high, const char* format,
                     bool logarithmic) {
  const Font font(ui.fonts.mono);
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID(id));
  ImGui::SetNextItemWidth(-1);
  // The interface's own number stands in the middle, whatever the knob does.
  if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const bool changed = ImGui::SliderFloat(id, &value, low, high, format,
                                          logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  if (!typing) ImGui::PopStyleColor();
  if (typing) return changed;
  std::array<char, 64> number{};
  std::snprintf(number.data(), number.size(), format, static_cast<double>(value));
  const float part = std::clamp(
      logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low), 0.0f, 1.0f);
  const ImVec2 from = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  const float margin = 2, knob = ImGui::GetStyle().GrabMinSize, gap = ui.px(5);
  const float left = from.x + margin + part * (end.x - from.x - 2 * margin - knob), right = left + knob;
  const float extent = text_size(number.data()).x, middle = (from.x + end.x) / 2;
  float x = middle - extent / 2;
  if (x < right + gap && x + extent > left - gap)
    x = left + knob / 2 > middle ? left - gap - extent : right + gap;
  draw_text(*ImGui::GetWindowDrawList(), ui.fonts.mono, {x, (from.y + end.y - ui.fonts.mono->FontSize) / 2},
            to_u32(ui.colors.text), number.data());
  return changed;
}

} // namespace isoscope::widgets
