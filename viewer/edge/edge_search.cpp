// What the search for a target left out, in words: how many Ψ, and the cells of the octree by their fate.
#include "model/words.h"
#include "edge/edge_parts.h"
#include "ui/widgets.h"
#include "scene/reason_style.h"

#include <array>

namespace isoscope::panels {
namespace {

/// A bold title with a switch at its right.
void switched_title(const Ui& ui, const char* title, std::string_view help, bool& on) {
  ImGui::Dummy({0, ui.px(4)});
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(title);
  ImGui::PushFont(ui.fonts.bold);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  widgets::tip(ui, title, help);
  ImGui::SameLine(left + width - ui.px(34));
  widgets::toggle(ui, "shown", on);
  widgets::tip(ui, on ? "Hide in the view" : "Show in the view");
  ImGui::PopID();
}

/// A colour, what it stands for, a number.
void legend_row(const Ui& ui, Rgb color, std::string_view title, std::string_view help,
                std::string_view value, bool filled) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), high = ui.px(20), r = ui.px(4.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{at.x + ui.px(8) - r, at.y + high / 2 - r}, end{low.x + 2 * r, low.y + 2 * r};
  if (filled) {
    list.AddRectFilled(low, end, to_u32(color, 0.25f));
    for (const float t : {0.7f, 1.3f})
      list.AddLine({low.x + r * (t - 0.7f), low.y + 2 * r * (t > 1 ? 1.0f : 0.65f)},
                   {low.x + 2 * r * (t > 1 ? 1.0f : 0.65f), low.y + r * (t - 0.7f)}, to_u32(color));
  }
  list.AddRect(low, end, to_u32(color), 0, 0, ui.px(1.2f));
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(ui.colors.text), title);
  const float extent =
      ui.fonts.mono
          ->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, value.data(), value.data() + value.size())
          .x;
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.text), value);
  ImGui::PushID(title.data(), title.data() + title.size());
  ImGui::InvisibleButton("legend", {width, high - ImGui::GetStyle().ItemSpacing.y});
  ImGui::PopID();
  widgets::tip(ui, title, help);
}

} // namespace

void search_regions(Ui& ui, const EdgeXray& x) {
  ViewSettings& view = ui.model.view;
  const CollapseAttempt& attempt = x.attempt;
  if (!attempt.invalid_regions.empty()) {
    switched_title(ui, "Invalid regions Ψ",
                   "Targets that must fail because one that was judged did; candidates inside are not asked "
                   "for. §2.4.1, §2.4.3",
                   view.invalid_regions);
    legend_row(ui, invalid_color, "drawn within the kernel", "The largest of them, hatched.",
               grouped(x.invalid.size()) + " of " + grouped(attempt.invalid_regions.size()), true);
  }
  if (const std::uint32_t judged = x.pruning.cells_judged + x.pruning.regions_judged; judged > 0) {
    widgets::verdict_glyph(ui, x.pruning.wrong.empty());
    ImGui::SameLine();
    ImGui::PushFont(ui.fonts.small);
    const std::string checked =
        x.pruning.wrong.empty() ? judged == 1 ? std::string("right: the point in it that was judged fails")
                                              : "right: " + grouped(judged) + " points in it judged, all fail"
                                : grouped(x.pruning.wrong.size()) + " of " + grouped(judged) + " would pass";
    ImGui::TextUnformatted(checked.c_str());
    ImGui::PopFont();
    widgets::tip(ui, "Was it right to leave them out?",
                 "Middles of Ψ and centres of the cells inside it, judged as if nothing were known.");
  }
  if (attempt.cells.empty()) return;
  switched_title(ui, "Octree over the kernel",
                 "Cells by least possible error; the centre of one that is not left out is a candidate. "
                 "§2.4.3",
                 view.octree_cells);
  std::array<std::size_t, fate_count> counts{};
  for (const OctreeCell& cell : attempt.cells) ++counts.at(static_cast<std::size_t>(cell.fate));
  for (std::size_t i = 0; i < fate_count; ++i) {
    if (counts[i] == 0) continue;
    const FateStyle& style = fate_style(static_cast<OctreeCell::Fate>(i));
    legend_row(ui, style.color, style.title, style.help, grouped(counts[i]), false);
  }
}

} // namespace isoscope::panels
