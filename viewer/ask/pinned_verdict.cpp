// Of edges what the X-ray says, of samples their class, of tetrahedra the conditions that they violate.
#include "ask/pinned_verdict.h"

#include "edge/edge_inspector.h"
#include "mesh/sample_sets.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>

namespace isoscope::panels {
namespace {

void judge_sample(const Ui& ui, const StateSnapshot& s, std::uint32_t id, ElementVerdict& v) {
  if (s.complex.form != ZeroForm::free && !s.classifies()) {
    v.words = "not judged yet";
    return;
  }
  if (id >= s.errors.size()) return;
  const auto error = static_cast<double>(s.errors[id]);
  const bool bad = is_bad(error);
  v.words = std::string(bad ? "bad" : "good") + ", ε = " + short_number(error);
  v.color = bad ? ui.colors.bad : ui.colors.good;
  v.shape = bad ? MarkerShape::cross : MarkerShape::disc;
}

void judge_tet(const Ui& ui, const StateSnapshot& s, std::uint32_t id, ElementVerdict& v) {
  if (id >= s.tet_flags.size() || s.complex.form != ZeroForm::interpolated) return;
  const std::uint8_t flags = s.tet_flags[id];
  std::string violated;
  const auto note = [&](TetFlag flag, const char* number, Rgb color) {
    if ((flags & flag) == 0) return;
    if (violated.empty()) v.color = color;
    violated += (violated.empty() ? "" : ", ") + std::string(number);
  };
  note(tet_violates_1, "1", ui.colors.bad);
  note(tet_violates_2, "2", ui.colors.warning);
  note(tet_violates_3, "3", ui.colors.misoriented);
  if (violated.empty()) {
    v.words = s.orientation_judged || (flags & tet_heterogeneous) == 0 ? "violates no condition"
                                                                       : "condition 3 not judged yet";
    v.color = s.orientation_judged ? ui.colors.good : ui.colors.quiet;
    return;
  }
  v.words = "violates " + violated;
  v.shape = MarkerShape::cross;
}

void draw_line(const Ui& ui, const ElementVerdict& v, ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, to_u32(v.color, 0.18f));
  list.AddLine({low.x, low.y + size.y - 1}, {low.x + size.x, low.y + size.y - 1}, to_u32(ui.colors.line),
               ui.px(1));
  const float middle = low.y + size.y / 2, y = middle - ui.fonts.ui->FontSize / 2;
  float x = low.x + ui.px(14);
  widgets::draw_text(list, ui.fonts.bold, {x, y}, to_u32(ui.colors.text), v.title);
  x += widgets::width_of(ui.fonts.bold, v.title) + ui.px(14);
  if (!v.words.empty()) {
    widgets::glyph(ui, {x, middle}, 4.5f, v.color, v.shape);
    const widgets::Font font(ui.fonts.small);
    widgets::draw_text(list, ui.fonts.small, {x + ui.px(11), middle - ui.fonts.small->FontSize / 2},
                       to_u32(ui.colors.text),
                       widgets::fitted(v.words, std::max(low.x + size.x - x - ui.px(40), 1.0f)));
  }
  widgets::draw_text(list, ui.fonts.ui, {low.x + size.x - ui.px(24), y}, to_u32(ui.colors.quiet), icon::up);
}

} // namespace

ElementVerdict element_verdict(const Ui& ui, const EdgeProbe& probe, const StateSnapshot& s) {
  const Pick& pick = ui.window.selection.picked;
  ElementVerdict v;
  v.color = ui.colors.quiet;
  v.shape = MarkerShape::circle;
  const std::string number = grouped(pick.id);
  switch (pick.kind) {
  case Pick::Kind::edge: {
    v.title = "Edge " + std::to_string(pick.id) + " – " + std::to_string(pick.other);
    if (const auto xray = probe.xray()) {
      const EdgeVerdict e = edge_verdict(ui, *xray);
      v.words = e.words;
      v.color = e.color;
      v.shape = e.shape;
    }
    break;
  }
  case Pick::Kind::sample:
    v.title = "Sample " + number;
    judge_sample(ui, s, pick.id, v);
    break;
  case Pick::Kind::tet:
    v.title = "Tetrahedron " + number;
    judge_tet(ui, s, pick.id, v);
    break;
  case Pick::Kind::vertex:
    v.title = "Vertex " + number;
    break;
  case Pick::Kind::facet:
    v.title = "Facet " + number;
    break;
  case Pick::Kind::over_rim:
    v.title = "Boundary sample " + number;
    break;
  case Pick::Kind::point:
    v.title = "Point " + number;
    break;
  case Pick::Kind::none:
    break;
  }
  return v;
}

void pinned_verdict(Ui& ui, const ElementVerdict& v) {
  const float scrolled = ImGui::GetScrollY();
  ui.window.inspector_scroll = scrolled;
  if (v.title.empty() || scrolled < ui.px(20)) return;
  const ImVec2 low = ImGui::GetWindowPos(), size{ImGui::GetWindowWidth(), ui.px(34)};
  // A window of its own: what was scrolled below it must not be pressed through it.
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(ui.colors.panel));
  ImGui::Begin("##pinned verdict", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const bool pressed = ImGui::InvisibleButton("top", size);
  draw_line(ui, v, low, size);
  widgets::tip(ui, "Back to the top", v.words);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (pressed) ImGui::SetScrollY(0);
}

} // namespace isoscope::panels
