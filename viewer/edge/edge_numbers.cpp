// Rows and bars of the numbers.
#include "edge/edge_numbers.h"

#include "edge/edge_journal.h"
#include "model/words.h"
#include "scene/reason_style.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::panels {
namespace {

/// Of δ: half-spaces that miss by less share boundary points, and nothing inside.
constexpr double touching = 1e-9;

double delta_of(const EdgeXray& x) {
  return x.criteria.delta > 0 ? x.criteria.delta : 1;
}

/// One candidate: glyph, number, reason; hovering shows its ghost, a click keeps it.
void candidate_row(Ui& ui, const EdgeXray& x, std::uint32_t i) {
  const CandidateRecord& c = x.attempt.candidates[i];
  const ReasonStyle& style = reason_style(c.rejected);
  Selection& selection = ui.window.selection;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), high = ui.px(20);
  ImGui::PushID(static_cast<int>(i));
  if (ImGui::InvisibleButton("candidate", {width, high})) ui.commands.post("candidate", {std::to_string(i)});
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) selection.hovered_candidate = i;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lit = selection.candidate == i;
  if (hovered || lit || selection.hovered_candidate == i)
    list.AddRectFilled({at.x - ui.px(4), at.y}, {at.x + width + ui.px(4), at.y + high},
                       to_u32(lit ? ui.colors.accent : ui.colors.hover, lit ? 0.25f : 1.0f), ui.px(4));
  widgets::glyph(ui, {at.x + ui.px(8), at.y + high / 2}, 4.0f, style.color, style.shape);
  const float y = at.y + (high - ui.fonts.small->FontSize) / 2;
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), y}, to_u32(ui.colors.quiet), std::to_string(i));
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(44), y}, to_u32(ui.colors.text), style.title);
  const Measured m = measured(c.rejected, c.value, c.limit, delta_of(x));
  const std::string value =
      m.number ? number_beside(m.value, m.limit) + (*m.unit ? " " : "") + m.unit : std::string();
  const float extent = widgets::width_of(ui.fonts.mono, value);
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.text), value);
  ImGui::SetCursorScreenPos({at.x, at.y + high});
}

/// A bold title with a switch at its right.
void switched_title(const Ui& ui, const char* title, std::string_view help, bool& on) {
  ImGui::Dummy({0, ui.px(4)});
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(title);
  widgets::bold_text(ui, title);
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
  const float extent = widgets::width_of(ui.fonts.mono, value);
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.text), value);
  ImGui::PushID(title.data(), title.data() + title.size());
  ImGui::InvisibleButton("legend", {width, high - ImGui::GetStyle().ItemSpacing.y});
  ImGui::PopID();
  widgets::tip(ui, title, help);
}

} // namespace

std::string check_text(CollapseCheck check, const CheckVerdict& v, const CollapseAttempt& attempt,
                       double delta) {
  switch (check) {
  case CollapseCheck::kernel:
    if (v.value <= 0 && -v.value < touching * delta) return "no room";
    return (v.value > 0 ? "r = " : "misses ") + short_number(std::abs(v.value) / delta) + " δ";
  case CollapseCheck::candidates:
    if (attempt.found_by == Reason::user && attempt.candidates.empty())
      return short_number(v.value / delta) + " δ inside";
    return grouped(attempt.tried) + " tried";
  case CollapseCheck::link:
  case CollapseCheck::zero_link: {
    const auto& simplices =
        check == CollapseCheck::link ? attempt.link.offending_t : attempt.link.offending_zero;
    return simplices.empty() ? std::string() : grouped(simplices.size()) + " simplices";
  }
  case CollapseCheck::witness:
    return v.witness == Vec3{} ? "none near" : short_number(v.value) + (v.value > 0 ? " > 0" : " ≤ 0");
  default:
    break;
  }
  const Measured m = measured(words(check).reason, v.value, v.limit, delta);
  if (!m.number || (v.witness == Vec3{} && v.value == 0)) return {};
  const std::string limit = m.limit == 1 ? "1" : m.limit == 0 ? "0" : short_number(m.limit);
  const std::string_view sign = m.upper ? " / " : m.value > m.limit ? " > " : " ≤ ";
  return number_beside(m.value, m.limit) + std::string(sign) + limit + (*m.unit ? " " : "") + m.unit;
}

void candidates(Ui& ui, const EdgeXray& x) {
  const std::size_t all = x.attempt.candidates.size();
  if (all == 0) return;
  widgets::subtitle(ui, "Candidates");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < x.candidates.size(); ++i) {
    const std::uint32_t n = x.candidates[i];
    if (n == 0) continue;
    const ReasonStyle& style = reason_style(static_cast<Reason>(i));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = ui.px(20);
    const float bar = width * static_cast<float>(n) / static_cast<float>(all);
    list.AddRectFilled({at.x, at.y + ui.px(2)}, {at.x + std::max(bar, ui.px(2)), at.y + high - ui.px(2)},
                       to_u32(style.color, 0.22f), ui.px(3));
    widgets::glyph(ui, {at.x + ui.px(8), at.y + high / 2}, 4.5f, style.color, style.shape);
    widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(20), at.y + (high - ui.fonts.small->FontSize) / 2},
                       to_u32(ui.colors.text), style.title);
    const std::string count = grouped(n);
    const float extent = widgets::width_of(ui.fonts.mono, count);
    widgets::draw_text(list, ui.fonts.mono,
                       {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                       to_u32(ui.colors.text), count);
    ImGui::PushID(static_cast<int>(i));
    ImGui::InvisibleButton("bar", {std::max(width, 1.0f), high - ImGui::GetStyle().ItemSpacing.y});
    ImGui::PopID();
    widgets::tip(ui, std::string(style.title), style.help);
  }
  widgets::quiet_text(ui, "One by one, keys I and Shift+I; hover for the ghost.");
  constexpr std::size_t rows = 7;
  const float high = ui.px(20) * static_cast<float>(std::min(all, rows)) + ui.px(4);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  if (ImGui::BeginChild("candidate-list", {0, high}, false)) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(all), ui.px(20));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        candidate_row(ui, x, static_cast<std::uint32_t>(i));
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void search_regions(Ui& ui, const EdgeXray& x) {
  ViewSettings& view = ui.window.view;
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

void kernel(Ui& ui, const EdgeXray& x) {
  if (!x.attempt.kernel) return;
  const double delta = delta_of(x);
  const Kernel& k = *x.attempt.kernel;
  widgets::subtitle(ui, "Kernel");
  if (k.empty) {
    widgets::value_row(ui, "half-spaces without a common point", grouped(k.witness.size()),
                       ui.colors.bad_text);
    if (k.missing_slack < touching * delta) {
      widgets::quiet_text(ui, "They share points of their boundaries and nothing inside: there is no room.",
                          true);
      return;
    }
    widgets::value_row(ui, "each misses by", short_number(k.missing_slack / delta) + " δ");
    widgets::value_row(ui, "as a length", short_number(k.missing_slack));
    float& push = ui.window.view.kernel_push;
    const std::string shown =
        "pushed " + short_number(static_cast<double>(push) * k.missing_slack / delta) + " δ";
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    widgets::slider(ui, "##push", push, 0, 1, shown.c_str());
    widgets::tip(
        ui, "Push the planes",
        "Moves the planes outwards; at the right end all of them meet in one point, the one that misses "
        "least. Helly: in space four half-spaces are always enough to tell.");
    return;
  }
  widgets::value_row(ui, "half-spaces", grouped(k.half_spaces.size()));
  widgets::value_row(ui, "inscribed radius", short_number(k.inscribed_radius / delta) + " δ");
  widgets::value_row(ui, "faces", grouped(x.kernel.faces.size()));
  widgets::value_row(ui, "volume", short_number(x.kernel.volume / (delta * delta * delta)) + " δ³");
}

void cost(Ui& ui, const EdgeXray& x, const TargetStudy* study) {
  const CollapseAttempt& attempt = x.attempt;
  if (!attempt.kernel || attempt.kernel->empty) return;
  const double delta = delta_of(x), square = delta * delta;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  if (at_gate(ui, collapse_check_count))
    gate_ground(ui, {top.x, top.y + ui.px(6)}, {ImGui::GetContentRegionAvail().x, ui.px(26)});
  widgets::subtitle(ui, "What the constraints cost");
  widgets::value_row(ui, "◇ least error, unconstrained",
                     short_number(attempt.unconstrained_cost / square) + " δ²");
  if (!attempt.possible() && !study) return;
  const double at = study ? study->attempt.cost : attempt.cost;
  const Vec3 target = study ? study->target : attempt.target;
  widgets::value_row(ui, study ? "error where you try" : "● error at the target",
                     short_number(at / square) + " δ²");
  const double least = attempt.unconstrained_cost;
  widgets::value_row(ui, "ratio", least > 0 ? short_number(at / least) + " ×" : at > 0 ? "∞" : "1 ×");
  widgets::value_row(ui, "from the optimum", short_number(distance(target, attempt.optimum) / delta) + " δ");
}

} // namespace isoscope::panels
