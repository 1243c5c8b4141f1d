// One click sets a breakpoint, another takes it away.
#include "debug/break_rows.h"

#include "debug/suggested_breaks.h"
#include "ui/widgets.h"

namespace isoscope::panels {
namespace {

/// A disc as in the gutter of a source debugger, the words, the condition below them.
void break_row(Ui& ui, const SuggestedBreak& b, bool set, bool first) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), high = ui.px(36);
  ImGui::PushID(b.condition.c_str());
  if (ImGui::InvisibleButton("break", {width, high})) ui.commands.post("break-here", {b.condition});
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered) {
    list.AddRectFilled({at.x - ui.px(4), at.y}, {at.x + width + ui.px(4), at.y + high},
                       to_u32(ui.colors.hover), ui.px(4));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  widgets::tip(ui, set ? "Take the breakpoint away" : "Stop at every event like this", b.condition);
  widgets::glyph(ui, {at.x + ui.px(8), at.y + ui.px(11)}, 4.5f, set ? ui.colors.bad_text : ui.colors.quiet,
                 set ? MarkerShape::disc : MarkerShape::circle);
  const float small = ui.fonts.small->FontSize;
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), at.y + ui.px(11) - small / 2},
                     to_u32(set ? ui.colors.text : ui.colors.accent_text), b.words);
  if (first) {
    const char* key = "F9";
    const float extent = widgets::width_of(ui.fonts.mono, key);
    widgets::draw_text(list, ui.fonts.mono,
                       {at.x + width - extent, at.y + ui.px(11) - ui.fonts.mono->FontSize / 2},
                       to_u32(ui.colors.quiet), key);
  }
  ImGui::PushFont(ui.fonts.small);
  const std::string shown = widgets::fitted(b.condition, width - ui.px(20));
  ImGui::PopFont();
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), at.y + ui.px(26) - small / 2},
                     to_u32(ui.colors.quiet), shown);
  ImGui::SetCursorScreenPos({at.x, at.y + high});
}

} // namespace

void break_rows(Ui& ui, const Debugger& debugger) {
  const auto suggested = suggested_breaks(debugger);
  if (suggested.empty()) return;
  widgets::subtitle(ui, "Stop at");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  for (std::size_t i = 0; i < suggested.size(); ++i)
    break_row(ui, suggested[i], breaks_on(debugger, suggested[i].condition), i == 0);
  ImGui::PopStyleVar();
  ImGui::Dummy({0, ui.px(4)});
}

} // namespace isoscope::panels
