// The history of the selected element: one line an entry, a click goes there.
#include "ask/investigation.h"

#include "journal/describe.h"
#include "model/words.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

constexpr float history_row_units = 22;

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
    std::string text = "Vertex " + id + ": " + counted(h.absorbed, "vertex", "vertices") + " ended in it";
    if (h.heir.valid() && h.heir.value != h.element.id)
      text += "; vertex " + grouped(h.heir.value) + " stands for it";
    return text;
  }
  case ElementRef::Kind::edge:
    return "Edge " + id + " – " + grouped(h.element.other) + ": " + counted(h.attempts, "attempt") + ", " +
           grouped(h.rejections) + " failed";
  case ElementRef::Kind::tet:
    return "Tetrahedron slot " + id + ": " + counted(h.changes(), "change");
  case ElementRef::Kind::sample:
    return "Sample " + id + ": " + counted(h.changes(), "change") + " of class";
  }
  return {};
}

void draw_row(Ui& ui, const ElementHistory& h, std::size_t index) {
  const HistoryRow& row = h.rows[index];
  widgets::Row line(ui, history_row_units);
  const bool pressed = line.button(index), here = row.step == ui.window.transport.step();
  if (line.hovered() || here) line.ground(ui.colors.hover, here ? 0.7f : 1.0f);
  const Journal& journal = *ui.window.run.journal;
  if (pressed) {
    if (h.element.kind == ElementRef::Kind::edge && !row.changes())
      ui.commands.post("event", {std::to_string(row.event)});
    else
      ui.commands.post("seek", {std::to_string(row.step)});
  }
  line.step(row.step);
  const RowStyle style = style_of(ui, row);
  line.glyph(80, style.color, style.shape);
  line.fitted(ui.fonts.small, 94, ui.colors.text, history_words(row, h.element.kind), ui.px(300));
  if (row.event < journal.events().size() && line.width > ui.px(480))
    line.fitted(ui.fonts.small, 400, ui.colors.quiet, describe(journal, journal.events()[row.event]),
                line.width - ui.px(410));
}

} // namespace

void history_tab(Ui& ui, const Investigation& asked) {
  if (!selected_element(ui.window.selection))
    return widgets::quiet_text(ui, "Select a vertex, an edge, a tetrahedron or a sample, then press H.",
                               true);
  const auto h = asked.history();
  if (!h || !ui.window.run.journal) return widgets::quiet_text(ui, "The journal is being read …");
  const widgets::Font font(ui.fonts.small);
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
  if (ImGui::BeginChild("history", {0, 0}))
    widgets::rows_in_sight(shown.size(), ui.px(history_row_units),
                           [&](std::size_t i) { draw_row(ui, *h, shown[i]); });
  ImGui::EndChild();
}

} // namespace isoscope::panels
