// One click sets a breakpoint, another takes it away.

#include "debug/debugger.h"
#include "ui/widgets.h"

namespace isoscope::panels {
namespace {

/// A disc as in the gutter of a source debugger, the words, the condition below them.
void break_row(Ui& ui, const SuggestedBreak& b, bool set, bool first) {
  widgets::Row row(ui, 36);
  if (row.button(b.condition.c_str())) ui.commands.post("break-here", {b.condition});
  row.link();
  const auto& [x, top] = row.at;
  widgets::tip(ui, set ? "Take the breakpoint away" : "Stop at every event like this", b.condition);
  widgets::glyph(ui, {x + ui.px(8), top + ui.px(11)}, 4.5f, set ? ui.colors.bad_text : ui.colors.quiet,
                 set ? MarkerShape::disc : MarkerShape::circle);
  const float small = ui.fonts.small->FontSize;
  widgets::draw_text(row.list, ui.fonts.small, {x + ui.px(20), top + ui.px(11) - small / 2},
                     to_u32(set ? ui.colors.text : ui.colors.accent_text), b.words);
  if (first) {
    const char* key = "F9";
    const float extent = widgets::width_of(ui.fonts.mono, key);
    widgets::draw_text(row.list, ui.fonts.mono,
                       {x + row.width - extent, top + ui.px(11) - ui.fonts.mono->FontSize / 2},
                       to_u32(ui.colors.quiet), key);
  }
  const widgets::Font font(ui.fonts.small);
  widgets::draw_text(row.list, ui.fonts.small, {x + ui.px(20), top + ui.px(26) - small / 2},
                     to_u32(ui.colors.quiet), widgets::fitted(b.condition, row.width - ui.px(20)));
  row.below();
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
