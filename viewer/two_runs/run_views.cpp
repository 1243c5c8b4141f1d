// A is always on the left: changing to the other run moves nothing.
#include "two_runs/run_views.h"

#include "model/words.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope {
namespace {

constexpr float strip_units = 28;
constexpr float narrow_units = 560; ///< a view below that wants the room of the left pane
constexpr float least_units = 300;  ///< and one below that the room of the inspector too

/// What the run was asked that the other one was not: "α 0.3  ·  σ/δ 0.4".
std::string told_apart(const Comparison& c, const ShownRun& run, bool b) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "  ·  ") + part; };
  if (run.shows_recording()) add(run.run.recording->file.filename().string());
  if (const auto found = c.found())
    for (const FieldDifference& p : found->parameters) add(p.name + " " + (b ? p.b : p.a));
  if (run.run.result && !run.run.result->branch.empty()) add(run.run.result->branch);
  return text.empty() ? run.run.parameters.input : text;
}

std::string place_of(const ShownRun& run) {
  const auto state = run.state();
  if (!state) return std::string(phase_word(run.run.phase));
  return "step " + grouped(state->step) + " of " + grouped(run.live_step()) + "  ·  Z " +
         grouped(state->zero_set.vertices.size()) + " vertices";
}

void strip(Ui& ui, const Comparison& c, bool b, float width) {
  const ShownRun* run = c.run(b);
  if (run == nullptr) return;
  const bool active = b == c.active_is_b();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float high = ui.px(strip_units);
  ImGui::InvisibleButton("strip", {width, high});
  if (ImGui::IsItemClicked() && !active) ui.commands.post("other-run");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + high},
                     to_u32(ImGui::IsItemHovered() && !active ? ui.colors.hover : ui.colors.panel));
  if (active)
    list.AddRectFilled({low.x, low.y + high - ui.px(2)}, {low.x + width, low.y + high},
                       to_u32(ui.colors.accent));
  const float badge = run_badge(ui, {low.x + ui.px(8), low.y + ui.px(4)}, b, active);
  const float y = low.y + (high - ui.fonts.small->FontSize) / 2, left = low.x + ui.px(16) + badge;
  std::string place = place_of(*run);
  float end = low.x + width - ui.px(10);
  if (end - widgets::width_of(ui.fonts.small, place) < left + ui.px(120) && run->state())
    place = "step " + grouped(run->state()->step);
  end -= widgets::width_of(ui.fonts.small, place);
  widgets::draw_text(list, ui.fonts.small, {end, y}, to_u32(ui.colors.quiet), place);
  ImGui::PushFont(ui.fonts.small);
  const std::string title = widgets::fitted(told_apart(c, *run, b), std::max(end - ui.px(12) - left, 1.0f));
  ImGui::PopFont();
  widgets::draw_text(list, ui.fonts.small, {left, y}, to_u32(active ? ui.colors.text : ui.colors.quiet),
                     title);
  widgets::tip(ui, std::string(b ? "Run B" : "Run A") + (active ? ", the active one" : "   Tab"),
               active ? "Panels, keys and questions speak of this run."
                      : "Click here or into the view: panels, keys and questions then speak of this run.");
}

} // namespace

float run_badge(const Ui& ui, ImVec2 at, bool b, bool active) {
  const float side = ui.px(19);
  const char* letter = b ? "B" : "A";
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{at.x + side, at.y + side};
  if (active)
    list.AddRectFilled(at, high, to_u32(ui.colors.accent), ui.px(4));
  else
    list.AddRect(at, high, to_u32(ui.colors.quiet), ui.px(4), 0, ui.px(1));
  widgets::draw_text(list, ui.fonts.bold,
                     {at.x + (side - widgets::width_of(ui.fonts.bold, letter)) / 2,
                      at.y + (side - ui.fonts.bold->FontSize) / 2},
                     to_u32(active ? ui.colors.on_accent : ui.colors.text), letter);
  return side;
}

void RunViews::make_room(Ui& ui) {
  WindowState& m = ui.window;
  PaneLayout& panes = m.settings.panes;
  if (!comparison_.beside()) {
    if (before_) {
      panes.show_left |= before_->show_left;
      panes.show_right |= before_->show_right;
      before_.reset();
      m.end_loan(LayoutGuest::two_views);
    }
    return;
  }
  if (before_) return;
  m.lend_layout(LayoutGuest::two_views);
  before_ = panes;
  const float half = ImGui::GetContentRegionAvail().x / 2 / ui.scale;
  if (half < narrow_units) panes.show_left = false;
  if (half + (before_->show_left ? panes.left / 2 : 0) < least_units) panes.show_right = false;
}

void RunViews::draw(Ui& ui) {
  make_room(ui);
  if (!comparison_.beside()) {
    other_.release();
    active_->draw(ui);
    return;
  }
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const ImVec2 low = ImGui::GetCursorScreenPos(), all = ImGui::GetContentRegionAvail();
  const float gap = ui.px(3), half = std::floor((all.x - gap) / 2);
  for (const bool b : {false, true}) {
    ImGui::SetCursorScreenPos({low.x + (b ? half + gap : 0), low.y});
    const ImVec2 size{b ? all.x - half - gap : half, all.y};
    if (ImGui::BeginChild(b ? "run B" : "run A", size, false, flags)) {
      const ImVec2 corner = ImGui::GetCursorScreenPos();
      strip(ui, comparison_, b, size.x);
      ImGui::SetCursorScreenPos({corner.x, corner.y + ui.px(strip_units)});
      if (b == comparison_.active_is_b())
        active_->draw(ui);
      else
        other_.draw(ui, comparison_);
    }
    ImGui::EndChild();
  }
}

} // namespace isoscope
