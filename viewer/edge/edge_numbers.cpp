// Kernel, candidates and cost of the edge under the X-ray.
#include "model/words.h"
#include "edge/edge_parts.h"
#include "ui/widgets.h"
#include "scene/reason_style.h"

#include <algorithm>
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
  Selection& selection = ui.model.selection;
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
  const float extent = ui.fonts.mono->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, value.c_str()).x;
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + width - extent, at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.text), value);
  ImGui::SetCursorScreenPos({at.x, at.y + high});
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
  subtitle(ui, "Candidates");
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
    const float extent = ui.fonts.mono->CalcTextSizeA(ui.fonts.mono->FontSize, 1e9f, 0, count.c_str()).x;
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

void kernel(Ui& ui, const EdgeXray& x) {
  if (!x.attempt.kernel) return;
  const double delta = delta_of(x);
  const Kernel& k = *x.attempt.kernel;
  subtitle(ui, "Kernel");
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
    float& push = ui.model.view.kernel_push;
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

void cost(Ui& ui, const EdgeXray& x) {
  const CollapseAttempt& attempt = x.attempt;
  if (!attempt.kernel || attempt.kernel->empty) return;
  const double delta = delta_of(x), square = delta * delta;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  if (at_gate(ui, collapse_check_count))
    gate_ground(ui, {top.x, top.y + ui.px(6)}, {ImGui::GetContentRegionAvail().x, ui.px(26)});
  subtitle(ui, "What the constraints cost");
  const auto study = ui.model.study();
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
