// The chosen range of steps on the timeline, and the line that tells where one is.
#include "model/words.h"
#include "timeline/timeline_panel.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>

namespace isoscope {

bool TimelinePane::choose_range(Ui& ui, double step) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool begins = ImGui::IsMouseClicked(0);
  if (begins && (io.KeyShift || io.KeyCtrl)) range_from_ = step;
  if (begins && !io.KeyShift && !io.KeyCtrl) range_from_.reset();
  if (!range_from_) return false;
  const auto live = static_cast<double>(ui.window.live_step());
  const auto place = [&](double at) { return static_cast<Step>(std::clamp(std::round(at), 0.0, live)); };
  ui.window.range = StepSpan{place(std::min(*range_from_, step)), place(std::max(*range_from_, step))};
  return true;
}

float TimelinePane::range_chip(Ui& ui, float left, float y) const {
  const auto& range = ui.window.range;
  if (!range) return 0;
  const std::string text = "range: " + grouped(range->begin) + "–" + grouped(range->end) + "  " + icon::close;
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 extent = widgets::text_size(text);
  ImGui::PopFont();
  const float width = extent.x + ui.px(20), high = ui.px(22);
  const ImVec2 before = ImGui::GetCursorScreenPos(), at{left, y + ui.px(3)};
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton("range chip", {width, high})) ui.commands.post("range");
  const bool hovered = ImGui::IsItemHovered();
  widgets::tip(
      ui, "Only these steps",
      "Lanes, plots, events, history, work and heat map count the chosen steps alone. A click or Esc "
      "counts all again; Shift or Ctrl and a drag on the timeline chooses others.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.accent, hovered ? 0.36f : 0.22f),
                     high / 2);
  list.AddRect(at, {at.x + width, at.y + high}, to_u32(ui.colors.accent), high / 2, 0, ui.px(1));
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(10), at.y + (high - extent.y) / 2},
                     to_u32(ui.colors.text), text);
  ImGui::SetCursorScreenPos(before);
  return width + ui.px(14);
}

void TimelinePane::shade_range(const Ui& ui, ImVec2 low, ImVec2 size) const {
  const auto& range = ui.window.range;
  if (!range) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float right = low.x + size.x;
  const float x0 = std::clamp(to_x(range->begin, low, size), low.x, right),
              x1 = std::clamp(to_x(range->end, low, size), low.x, right);
  const ImU32 shade = to_u32(ui.colors.ground, 0.72f), edge = to_u32(ui.colors.accent_text, 0.8f);
  list.AddRectFilled(low, {x0, low.y + size.y}, shade);
  list.AddRectFilled({x1, low.y}, {right, low.y + size.y}, shade);
  list.AddLine({x0, low.y}, {x0, low.y + size.y}, edge, ui.px(1));
  list.AddLine({x1, low.y}, {x1, low.y + size.y}, edge, ui.px(1));
}

void TimelinePane::forecast_band(const Ui& ui, ImVec2 low, ImVec2 size) const {
  const auto& forecast = ui.window.forecast;
  if (!forecast) return;
  const double s = forecast->seconds;
  const std::string time = s < 1      ? "less than a second"
                           : s < 90   ? "about " + general(std::round(s), 3) + " s"
                           : s < 5400 ? "about " + general(std::round(s / 60), 3) + " min"
                                      : "about " + general(s / 3600, 2) + " h";
  const std::string text = time + " from here";
  const float x0 = std::max(to_x(forecast->from, low, size), low.x), x1 = low.x + size.x;
  if (x0 >= x1) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float extent = widgets::width_of(ui.fonts.small, text), high = ui.px(18);
  list.AddRectFilled({x0, low.y}, {x1, low.y + size.y}, to_u32(ui.colors.accent, 0.07f));
  list.AddLine({x0, low.y}, {x0, low.y + size.y}, to_u32(ui.colors.accent), ui.px(1));
  // Near the right end the words stand before the step.
  const float x = x0 + extent + ui.px(16) < x1 ? x0 + ui.px(4) : x0 - extent - ui.px(16);
  const float y = low.y + size.y - high - ui.px(4);
  list.AddRectFilled({x, y}, {x + extent + ui.px(12), y + high}, to_u32(ui.colors.panel, 0.9f), ui.px(4));
  list.AddRect({x, y}, {x + extent + ui.px(12), y + high}, to_u32(ui.colors.accent), ui.px(4), 0, ui.px(1));
  widgets::draw_text(list, ui.fonts.small, {x + ui.px(6), y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(ui.colors.text), text);
}

void TimelinePane::breadcrumb_line(const Ui& ui, float left, float y) const {
  const WindowState& m = ui.window;
  if (!m.run.journal || m.live_step() == 0) return;
  const std::string text = debugger_.breadcrumb();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {left, y + (ui.px(28) - ui.fonts.small->FontSize) / 2}, to_u32(ui.colors.quiet),
                     widgets::fitted(text, right - left - ui.px(8)));
}

} // namespace isoscope
