// A chip of one line; a click on it, or the command, unfolds the sentences below it.
#include "view/warning_chip.h"

#include "base/numbers.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <string>
#include <vector>

namespace isoscope::overlay {
namespace {

/// The gravest in a few words, and how many more there are.
std::string chip_words(const WindowState& m, const std::vector<std::string>& texts) {
  std::string first = texts[0];
  if (m.no_thickening()) {
    const ExpectedTopology& expected = m.run.scene->expected;
    const bool promised = expected.required && expected.euler_characteristic;
    first = "Ω is no thickening: topology " +
            (promised ? "from " + expected.source : std::string("is not guaranteed"));
  }
  return texts.size() == 1 ? first : first + "  ·  " + grouped(texts.size() - 1) + " more";
}

/// The sentences, each with its sign, in a box as high as they are.
void full_text(const Ui& ui, const std::vector<std::string>& texts, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = ui.px(12), indent = ui.px(20), gap = ui.px(6), room = width - 2 * pad - indent;
  std::vector<std::string> broken;
  float high = 2 * pad - gap;
  for (const std::string& text : texts) {
    broken.push_back(widgets::broken_lines(ui.fonts.small, text, room));
    high += widgets::height_of(ui.fonts.small, broken.back()) + gap;
  }
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.panel, 0.97f), ui.px(6));
  list.AddRect(at, {at.x + width, at.y + high}, to_u32(ui.colors.warning, 0.7f), ui.px(6));
  float y = at.y + pad;
  for (const std::string& lines : broken) {
    widgets::draw_text(list, ui.fonts.small, {at.x + pad, y}, to_u32(ui.colors.warning_text), icon::warning);
    widgets::draw_text(list, ui.fonts.small, {at.x + pad + indent, y}, to_u32(ui.colors.text), lines);
    y += widgets::height_of(ui.fonts.small, lines) + gap;
  }
}

} // namespace

float warning_chip(Ui& ui, ImVec2 low, ImVec2 size) {
  const std::vector<std::string> texts = ui.window.warnings();
  const float high = ui.px(26), room = size.x - ui.px(24);
  if (texts.empty() || room < ui.px(60)) return 0;
  const ImVec2 at{low.x + ui.px(12), low.y + ui.px(42)};
  std::string words = chip_words(ui.window, texts);
  {
    const widgets::Font font(ui.fonts.small);
    words = widgets::fitted(words, std::min(room, ui.px(460)) - ui.px(54));
  }
  const float width = widgets::width_of(ui.fonts.small, words) + ui.px(54);
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton("warnings", {width, high})) ui.commands.post("warnings");
  const bool hovered = ImGui::IsItemHovered(), open = ui.window.warnings_open;
  if (!open) widgets::tip(ui, "Warnings", "What the user should know of this run. A click shows it in full.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + width, at.y + high};
  list.AddRectFilled(at, end, to_u32(hovered ? ui.colors.hover : ui.colors.panel, 0.92f), ui.px(6));
  list.AddRect(at, end, to_u32(ui.colors.warning, 0.8f), ui.px(6));
  const float y = at.y + (high - ui.fonts.small->FontSize) / 2;
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(9), y}, to_u32(ui.colors.warning_text),
                     icon::warning);
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(28), y}, to_u32(ui.colors.text), words);
  widgets::draw_text(list, ui.fonts.small, {end.x - ui.px(17), y}, to_u32(ui.colors.quiet),
                     open ? icon::up : icon::down);
  if (open) full_text(ui, texts, {at.x, end.y + ui.px(4)}, std::min(room, ui.px(520)));
  return high + ui.px(6);
}

} // namespace isoscope::overlay
