// The history of the selected element: one line an entry, a click goes there.
#include "ask/history_panel.h"

#include "journal/describe.h"
#include "model/words.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

struct RowStyle {
  Rgb color;
  MarkerShape shape;
};

/// Green and a disc: done; red and a cross: failed or bad; quiet: what only concerns it.
RowStyle style_of(const Ui& ui, const HistoryRow& row) {
  switch (row.kind) {
  case HistoryRow::Kind::collapsed:
  case HistoryRow::Kind::became_good:
    return {ui.colors.good, MarkerShape::disc};
  case HistoryRow::Kind::rejected:
  case HistoryRow::Kind::became_bad:
    return {ui.colors.bad, MarkerShape::cross};
  case HistoryRow::Kind::moved:
  case HistoryRow::Kind::absorbed:
  case HistoryRow::Kind::merged:
  case HistoryRow::Kind::relabeled:
  case HistoryRow::Kind::sided:
    return {ui.colors.accent, MarkerShape::diamond};
  case HistoryRow::Kind::born:
  case HistoryRow::Kind::gone:
  case HistoryRow::Kind::asked:
  case HistoryRow::Kind::other_set:
    break;
  }
  return {ui.colors.quiet, MarkerShape::circle};
}

std::string summary(const ElementHistory& h) {
  const std::string id = grouped(h.element.id);
  switch (h.element.kind) {
  case ElementRef::Kind::vertex: {
    std::string text = "Vertex " + id + ": " + grouped(h.absorbed) +
                       (h.absorbed == 1 ? " vertex" : " vertices") + " ended in it";
    if (h.heir.valid() && h.heir.value != h.element.id)
      text += "; vertex " + grouped(h.heir.value) + " stands for it";
    return text;
  }
  case ElementRef::Kind::edge:
    return "Edge " + id + " – " + grouped(h.element.other) + ": " + grouped(h.attempts) +
           (h.attempts == 1 ? " attempt, " : " attempts, ") + grouped(h.rejections) + " failed";
  case ElementRef::Kind::tet:
    return "Tetrahedron slot " + id + ": " + grouped(h.changes()) +
           (h.changes() == 1 ? " change" : " changes");
  case ElementRef::Kind::sample:
    return "Sample " + id + ": " + grouped(h.changes()) +
           (h.changes() == 1 ? " change of class" : " changes of class");
  }
  return {};
}

void draw_row(Ui& ui, const ElementHistory& h, std::size_t index, float high) {
  const HistoryRow& row = h.rows[index];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(static_cast<int>(index));
  const bool pressed = ImGui::InvisibleButton("row", {width, high});
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool here = row.step == ui.window.transport.step();
  if (ImGui::IsItemHovered() || here)
    list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.hover, here ? 0.7f : 1.0f),
                       ui.px(4));
  const Journal& journal = *ui.window.run.journal;
  if (pressed) {
    if (h.element.kind == ElementRef::Kind::edge && !row.changes())
      ui.commands.post("event", {std::to_string(row.event)});
    else
      ui.commands.post("seek", {std::to_string(row.step)});
  }
  const float y = at.y + (high - ui.fonts.small->FontSize) / 2;
  const std::string step = grouped(row.step);
  const float extent = widgets::width_of(ui.fonts.mono, step);
  widgets::draw_text(list, ui.fonts.mono, {at.x + ui.px(64) - extent, y}, to_u32(ui.colors.quiet), step);
  const RowStyle style = style_of(ui, row);
  widgets::glyph(ui, {at.x + ui.px(80), at.y + high / 2}, 4.5f, style.color, style.shape);
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(94), y}, to_u32(ui.colors.text),
                     widgets::fitted(history_words(row, h.element.kind), ui.px(300)));
  if (row.event < journal.events().size() && width > ui.px(480))
    widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(400), y}, to_u32(ui.colors.quiet),
                       widgets::fitted(describe(journal, journal.events()[row.event]), width - ui.px(410)));
}

} // namespace

void history_tab(Ui& ui, const Investigation& asked) {
  if (!selected_element(ui.window.selection))
    return widgets::quiet_text(ui, "Select a vertex, an edge, a tetrahedron or a sample, then press H.",
                               true);
  const auto h = asked.history();
  if (!h || !ui.window.run.journal) return widgets::quiet_text(ui, "The journal is being read …");
  ImGui::PushFont(ui.fonts.small);
  std::string words = summary(*h);
  if (h->steps < ui.window.live_step()) words += "; up to step " + grouped(h->steps);
  ImGui::TextUnformatted(words.c_str());
  std::vector<std::size_t> shown;
  const auto& range = ui.window.range;
  for (std::size_t i = 0; i < h->rows.size(); ++i)
    if (!range || range->holds(h->rows[i].step)) shown.push_back(i);
  if (h->rows.empty())
    widgets::quiet_text(ui, "Nothing happened to it.");
  else if (shown.size() < h->rows.size())
    widgets::quiet_text(ui,
                        grouped(shown.size()) + " of " + grouped(h->rows.size()) + " rows are in the range.");
  if (ImGui::BeginChild("history", {0, 0})) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const float high = ui.px(22);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.size()), high);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        draw_row(ui, *h, shown[static_cast<std::size_t>(i)], high);
    ImGui::PopStyleVar();
  }
  ImGui::EndChild();
  ImGui::PopFont();
}

} // namespace isoscope::panels
