// The stage as a heading, the paper's figure, and what colours and marks of the scene mean.
#include "talk/talk.h"

#include "journal/vocabulary.h"
#include "scene/first_box.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cctype>

namespace isoscope::panels {
namespace {

struct LegendRow {
  Rgb color;
  MarkerShape shape;
  std::string_view text;
};

/// What is drawn at the step shown, the mesh first.
std::vector<LegendRow> legend_rows(const Ui& ui) {
  const WindowState& m = ui.window;
  const ViewSettings view = m.shown_view();
  const Palette& c = ui.colors;
  std::vector<LegendRow> rows;
  const auto state = m.state();
  if (!state) return rows;
  const bool has_mesh = !state->zero_set.polygons.empty();
  const bool asked = !state->errors.empty() && state->step > 0; // before that nothing is judged
  const auto add = [&](bool shown, Rgb color, MarkerShape shape, std::string_view text) {
    if (shown) rows.push_back({color, shape, text});
  };
  add(!first_box(*state).empty(), c.quiet, MarkerShape::hollow_square, "the box that T begins as");
  add(has_mesh && view.zero_set.shown(), c.zero, MarkerShape::square, "Z, the mesh");
  add(view.outer.shown(), c.outer, MarkerShape::square, "outer boundary of Ω");
  add(view.inner.shown(), c.inner, MarkerShape::square, "inner boundary of Ω");
  add(asked && view.samples.shown() && view.good_samples.shown(), c.good, MarkerShape::disc, "good sample");
  add(asked && view.samples.shown() && view.bad_samples.shown() && state->bad_samples > 0, c.bad,
      MarkerShape::cross, "bad sample");
  add(m.rim() != nullptr && view.rim.shown(), c.rim, MarkerShape::diamond, "rim of the input");
  add(view.tetrahedra.shown() && view.tets.violate_3 && state->violating_3 > 0,
      condition_color(ui.theme, static_cast<int>(Condition::orientation)), MarkerShape::square,
      "misoriented tetrahedron");
  add(m.selection.picked.kind == Pick::Kind::edge, c.selection, MarkerShape::disc, "the edge in question");
  return rows;
}

std::string capital(std::string_view words) {
  std::string text(words);
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

} // namespace

float presenter_legend(const Ui& ui, const Talk& talk, ImVec2 low) {
  const auto kept = ui.window.state(); // the event may be its own
  if (!kept) return low.y;
  const Event* event = talk.caption_event();
  const std::string title = capital(words(event != nullptr ? event->stage : Stage::setup).plain);
  const std::string figure = talk.caption_figure();
  const std::vector<LegendRow> rows = legend_rows(ui);
  const float pad = ui.px(12), mark = ui.px(18), small = ui.fonts.small->FontSize,
              row_high = small + ui.px(3);
  float wide = widgets::width_of(ui.fonts.bold, title);
  if (!figure.empty()) wide += ui.px(12) + widgets::width_of(ui.fonts.small, figure);
  for (const LegendRow& row : rows) wide = std::max(wide, mark + widgets::width_of(ui.fonts.small, row.text));
  const ImVec2 at{low.x + ui.px(10), low.y + ui.px(10)};
  const float title_high = ui.fonts.bold->FontSize + ui.px(6);
  const float high = title_high + row_high * static_cast<float>(rows.size()) + 2 * ui.px(8);
  // A ground of its own: the scene behind may be as bright as the text.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + wide + 2 * pad, at.y + high}, to_u32(ui.colors.ground, 0.78f), ui.px(8));
  float y = at.y + ui.px(8);
  widgets::draw_text(list, ui.fonts.bold, {at.x + pad, y}, to_u32(ui.colors.text), title);
  if (!figure.empty())
    widgets::draw_text(list, ui.fonts.small,
                       {at.x + pad + wide - widgets::width_of(ui.fonts.small, figure),
                        y + (ui.fonts.bold->FontSize - small) / 2},
                       to_u32(ui.colors.quiet), figure);
  y += title_high;
  for (const LegendRow& row : rows) {
    widgets::glyph(ui, {at.x + pad + ui.px(5), y + row_high / 2}, 4.5f, row.color, row.shape);
    widgets::draw_text(list, ui.fonts.small, {at.x + pad + mark, y + (row_high - small) / 2},
                       to_u32(ui.colors.text), row.text);
    y += row_high;
  }
  return at.y + high;
}

} // namespace isoscope::panels
