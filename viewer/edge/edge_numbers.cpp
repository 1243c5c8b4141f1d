// Rows and bars of the numbers.
#include "edge/edge_inspector.h"

#include "model/words.h"
#include "questions/outside_kernel.h"
#include "scene/search_regions.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::panels {
namespace {

constexpr float number_row_units = 20;

/// Of δ: half-spaces that miss by less share boundary points, and nothing inside.
constexpr double touching = 1e-9;

/// One candidate: glyph, number, reason; hovering shows its ghost, a click keeps it.
void candidate_row(Ui& ui, const EdgeXray& x, std::uint32_t i) {
  const CandidateRecord& c = x.attempt.candidates[i];
  const ReasonWords& style = words(c.rejected);
  Selection& selection = ui.window.selection;
  widgets::Row row(ui, number_row_units);
  if (row.button(i)) ui.commands.post("candidate", {std::to_string(i)});
  if (row.hovered()) selection.hovered_candidate = i;
  const bool lit = selection.candidate == i;
  if (lit || selection.hovered_candidate == i)
    row.ground(lit ? ui.colors.accent : ui.colors.hover, lit ? 0.25f : 1.0f, 4);
  row.glyph(8, style.color, style.shape, 4.0f);
  row.text(ui.fonts.small, 20, ui.colors.quiet, std::to_string(i));
  row.text(ui.fonts.small, 44, ui.colors.text, style.title);
  const Measured m = measured(words(c.rejected).measure, c.value, c.limit, x.criteria.unit());
  if (m.number) row.value(ui.colors.text, number_beside(m.value, m.limit) + (*m.unit ? " " : "") + m.unit);
  row.below();
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

/// Completes a row by what it stands for, a number and a tooltip.
void told_row(const Ui& ui, const widgets::Row& row, std::string_view title, std::string_view help,
              std::string_view value) {
  row.text(ui.fonts.small, 20, ui.colors.text, title);
  row.value(ui.colors.text, value);
  ImGui::PushID(title.data(), title.data() + title.size());
  ImGui::InvisibleButton("legend", {row.width, row.high - ImGui::GetStyle().ItemSpacing.y});
  ImGui::PopID();
  widgets::tip(ui, title, help);
}

/// A colour, what it stands for, a number.
void legend_row(const Ui& ui, Rgb color, std::string_view title, std::string_view help,
                std::string_view value, bool filled) {
  const widgets::Row row(ui, number_row_units);
  const float r = ui.px(4.5f);
  const ImVec2 low{row.at.x + ui.px(8) - r, row.at.y + row.high / 2 - r}, end{low.x + 2 * r, low.y + 2 * r};
  ImDrawList& list = row.list;
  if (filled) {
    list.AddRectFilled(low, end, to_u32(color, 0.25f));
    for (const float t : {0.7f, 1.3f})
      list.AddLine({low.x + r * (t - 0.7f), low.y + 2 * r * (t > 1 ? 1.0f : 0.65f)},
                   {low.x + 2 * r * (t > 1 ? 1.0f : 0.65f), low.y + r * (t - 0.7f)}, to_u32(color));
  }
  list.AddRect(low, end, to_u32(color), 0, 0, ui.px(1.2f));
  told_row(ui, row, title, help, value);
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
  const Measured m = measured(words(words(check).reason).measure, v.value, v.limit, delta);
  if (!m.number || (v.witness == Vec3{} && v.value == 0)) return {};
  const std::string limit = m.limit == 1 ? "1" : m.limit == 0 ? "0" : short_number(m.limit);
  const std::string_view sign = m.upper ? " / " : m.value > m.limit ? " > " : " ≤ ";
  return number_beside(m.value, m.limit) + std::string(sign) + limit + (*m.unit ? " " : "") + m.unit;
}

void outside_kernel(Ui& ui, const EdgeXray& x) {
  if (x.attempt.rejected != Reason::no_candidate) return;
  const auto points = points_outside(x);
  if (points.empty()) return;
  widgets::subtitle(ui, "Outside the kernel");
  const ReasonWords& style = words(Reason::no_candidate);
  for (std::size_t i = 0; i < points.size(); ++i) {
    using What = OutsidePoint::What;
    const OutsidePoint& p = points[i];
    const std::string title = p.what == What::kept_end
                                  ? "end " + std::to_string(x.star.a().value) + ", which stays"
                              : p.what == What::removed_end ? "end " + std::to_string(x.star.b().value)
                                                            : std::string("the place of least error");
    widgets::Row row(ui, number_row_units);
    const bool pressed = row.button(i);
    row.link();
    if (pressed) ui.window.selection.try_target(p.point);
    row.glyph(8, style.color, style.shape, 4.5f);
    row.text(ui.fonts.small, 20, ui.colors.text, title);
    row.value(ui.colors.bad_text, short_number(p.outside / x.criteria.unit()) + " δ outside");
    widgets::tip(ui, title,
                 "Beyond half-space " + std::to_string(p.half_space) +
                     " of the kernel: from there a facet of the one-ring is seen from behind. A click tries "
                     "it as a target.");
    row.below();
  }
  if (!x.halfedge)
    widgets::quiet_text(ui, "Every other point that the search would judge lies outside, too.", true);
}

void candidates(Ui& ui, const EdgeXray& x) {
  const std::size_t all = x.attempt.candidates.size();
  if (all == 0) return;
  widgets::subtitle(ui, "Candidates");
  for (std::size_t i = 0; i < x.candidates.size(); ++i) {
    const std::uint32_t n = x.candidates[i];
    if (n == 0) continue;
    const ReasonWords& style = words(static_cast<Reason>(i));
    const widgets::Row row(ui, number_row_units);
    const float bar = row.width * static_cast<float>(n) / static_cast<float>(all);
    row.list.AddRectFilled({row.at.x, row.at.y + ui.px(2)},
                           {row.at.x + std::max(bar, ui.px(2)), row.at.y + row.high - ui.px(2)},
                           to_u32(style.color, 0.22f), ui.px(3));
    row.glyph(8, style.color, style.shape);
    told_row(ui, row, style.title, style.help, grouped(n));
  }
  widgets::quiet_text(ui, "One by one, keys I and Shift+I; hover for the ghost.");
  constexpr std::size_t rows = 7;
  const float high = ui.px(number_row_units) * static_cast<float>(std::min(all, rows)) + ui.px(4);
  if (ImGui::BeginChild("candidate-list", {0, high}, false))
    widgets::rows_in_sight(all, ui.px(number_row_units),
                           [&](std::size_t i) { candidate_row(ui, x, static_cast<std::uint32_t>(i)); });
  ImGui::EndChild();
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
    const std::string checked =
        x.pruning.wrong.empty() ? judged == 1 ? std::string("right: the point in it that was judged fails")
                                              : "right: " + grouped(judged) + " points in it judged, all fail"
                                : grouped(x.pruning.wrong.size()) + " of " + grouped(judged) + " would pass";
    widgets::verdict_text(ui, x.pruning.wrong.empty(), checked);
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
  const double delta = x.criteria.unit();
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
  const double delta = x.criteria.unit(), square = delta * delta;
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
