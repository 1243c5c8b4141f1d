// Every check live, before and after; the neighbours that were tried.
#include "edge/edge_inspector.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "ui/answer.h"
#include "ui/widgets.h"

#include <array>

namespace isoscope::panels {
namespace {

using State = CheckVerdict::State;

/// A check of the study: glyph, title, the number before the collapse and after it.
void change_row(Ui& ui, const EdgeXray& x, const TargetStudy& study, CollapseCheck check) {
  const CheckVerdict& v = study.attempt.check(check);
  if (v.state == State::skipped) return;
  const double delta = x.criteria.unit();
  widgets::Row row(ui, 21);
  const bool pressed = row.button(static_cast<std::size_t>(check));
  if (row.hovered()) row.ground(ui.colors.hover, 1, 4);
  if (pressed && witness_of(x, study.attempt, check)) ui.commands.post("witness", {std::string(name(check))});
  const bool good = v.state == State::passed;
  row.verdict(8, good);
  const std::string_view title = check == CollapseCheck::candidates ? "in the kernel" : words(check).title;
  row.text(ui.fonts.small, 20, ui.colors.text, title);
  std::string value = check_text(check, v, study.attempt, delta);
  for (const TargetStudy::Change& change : study.changes) {
    if (change.check != check || !change.before) continue;
    const bool length = check == CollapseCheck::containment;
    value = short_number(change.before->value / (length ? delta : 1)) + " → " + value;
  }
  row.value(good ? ui.colors.text : ui.colors.bad_text, value);
  widgets::tip(ui, title, std::string(words(check).help) + " Before the collapse → after it.");
  row.below();
}

void coordinates(Ui& ui, Vec3 target, double delta) {
  std::array<double, 3> xyz{target.x, target.y, target.z};
  ImGui::PushFont(ui.fonts.mono);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::InputScalarN("##target", ImGuiDataType_Double, xyz.data(), 3, nullptr, nullptr, "%.5g",
                          ImGuiInputTextFlags_EnterReturnsTrue))
    ui.window.selection.try_target(Vec3{xyz[0], xyz[1], xyz[2]});
  ImGui::PopFont();
  widgets::tip(ui, "The target",
               "Type a place, drag it in the view, or nudge it with Shift and the arrows: δ/50 each, δ = " +
                   short_number(delta) + ".");
}

void snap_buttons(Ui& ui) {
  struct Snap {
    const char *label, *word, *help;
  };
  constexpr std::array<Snap, 6> snaps{
      {{"optimum", "optimum", "Where the error is least without constraints."},
       {"best", "best", "The least error in the kernel."},
       {"found", "found", "What the search found."},
       {"vertex", "vertex", "The nearest vertex of the kernel."},
       {"centre", "center", "Of the largest ball in the kernel."},
       {"end", "kept", "The end of the edge that stays."}}};
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ui.px(4)) / 3;
  const widgets::Font font(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4), ui.px(4)});
  for (std::size_t i = 0; i < snaps.size(); ++i) {
    if (i % 3 != 0) ImGui::SameLine();
    if (widgets::plain_button(ui, snaps.at(i).label, true, width, ui.px(24)))
      ui.commands.post("what-if", {snaps.at(i).word});
    widgets::tip(ui, snaps.at(i).help);
  }
  ImGui::PopStyleVar();
}

} // namespace

void what_if(Ui& ui, const EdgeProbe& probe, const EdgeXray& x) {
  const widgets::AnswerRegion region(ui, AnswerKind::what_if, probe.study() != nullptr);
  widgets::subtitle(ui, "What if the target were elsewhere?");
  const Selection& selection = ui.window.selection;
  if (!selection.what_if) {
    if (widgets::plain_button(ui, "Try a target", true, ImGui::GetContentRegionAvail().x))
      ui.commands.post("what-if");
    widgets::tip(ui, "Try a target", "Or take the target in the view and drag it. Key M.");
    return;
  }
  const double delta = x.criteria.unit();
  const auto study = probe.study();
  if (!study) {
    widgets::quiet_text(ui, "The target is being judged.");
    return;
  }
  const bool possible = study->attempt.possible();
  widgets::verdict_text(ui, possible,
                        possible ? "could collapse to here"
                                 : "not to here: " + std::string(words(study->attempt.rejected).title));
  coordinates(ui, study->target, delta);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  for (std::size_t i = 0; i < collapse_check_count; ++i)
    change_row(ui, x, *study, static_cast<CollapseCheck>(i));
  ImGui::PopStyleVar();
  ImGui::Dummy({0, ui.px(2)});
  snap_buttons(ui);
  const float half = (ImGui::GetContentRegionAvail().x - ui.px(6)) / 2;
  if (widgets::primary_button(ui, "Do it: branch", possible, half)) ui.commands.post("do-it");
  widgets::tip(
      ui, "Branch the run here",
      "A new run begins with this state and this collapse and goes on from there; the present one is kept. "
      "Ctrl+D.");
  ImGui::SameLine(0, ui.px(6));
  if (widgets::plain_button(ui, "Leave", true, half)) ui.commands.post("what-if", {"off"});
}

void unlock(Ui& ui, EdgeProbe& probe) {
  const widgets::AnswerRegion region(ui, AnswerKind::unlock, probe.unlock_search() != nullptr);
  widgets::subtitle(ui, "What would unlock it?");
  if (probe.unlocking()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = ui.px(8);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.line), high / 2);
    list.AddRectFilled(
        at, {at.x + width * static_cast<float>(std::max(probe.unlock_fraction(), 0.0)), at.y + high},
        to_u32(ui.colors.accent), high / 2);
    ImGui::Dummy({width, high});
    if (widgets::plain_button(ui, "Cancel", true, width)) probe.stop_unlocking();
    return;
  }
  const auto search = probe.unlock_search();
  if (!search) {
    if (widgets::plain_button(ui, "Try the neighbours", true, ImGui::GetContentRegionAvail().x))
      ui.commands.post("unlock");
    widgets::tip(
        ui, "Try the neighbours",
        "Collapses every edge between Z and Γ around this one on a copy and judges this one again. Key U. "
        "§2.4.4, Figure 13");
    return;
  }
  widgets::value_row(ui, "neighbours tried", grouped(search->trials.size()));
  widgets::value_row(ui, "make it possible", grouped(search->count()),
                     search->count() > 0 ? ui.colors.good_text : ui.colors.bad_text);
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < search->trials.size() && i < most; ++i) {
    const UnlockTrial& t = search->trials[i];
    if (!t.unlocks()) break;
    if (widgets::link_row(ui, "trial", "first collapse",
                          std::to_string(t.a.value) + " – " + std::to_string(t.b.value),
                          "Selects that edge: try its target and branch the run there.", i))
      ui.commands.post("pick", {"edge", std::to_string(t.a.value), std::to_string(t.b.value)});
  }
}

} // namespace isoscope::panels
