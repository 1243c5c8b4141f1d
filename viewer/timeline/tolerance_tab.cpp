// The diagram of δ, its handle, and the figures beside it.
#include "timeline/tolerance_tab.h"

#include "base/numbers.h"
#include "model/tolerance_step.h"
#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace isoscope::panels {
namespace {

/// What the diagram draws over δ, on logarithmic axes.
struct Curve {
  const char* name;
  std::size_t DeltaStudy::Step::*value;
  Rgb color;
};

/// From δ and numbers to the screen and back.
struct Frame {
  ImVec2 low, high;
  double least, most; ///< δ
  double largest;     ///< number, at the top

  float x(double delta) const {
    const double part = std::log(delta / least) / std::log(most / least);
    return low.x + static_cast<float>(std::clamp(part, 0.0, 1.0)) * (high.x - low.x);
  }
  float y(double number) const {
    // None stands below one.
    const double part = number < 1 ? 0.03 : 0.17 + 0.75 * std::log(number) / std::log(largest);
    return high.y - static_cast<float>(part) * (high.y - low.y);
  }
  double delta_at(float place) const {
    const double part = std::clamp(static_cast<double>((place - low.x) / (high.x - low.x)), 0.0, 1.0);
    return least * std::pow(most / least, part);
  }
};

std::string percent_text(double length, double edge) {
  return short_number(100 * length / edge) + " %";
}

void steps(const Ui& ui, const DeltaStudy& study, const Frame& frame, const Curve& curve) {
  std::vector<ImVec2> line;
  for (const DeltaStudy::Step& step : study.curve) {
    const float x = frame.x(step.delta), y = frame.y(static_cast<double>(step.*(curve.value)));
    if (!line.empty() && line.back().y == y && &step != &study.curve.back()) continue;
    if (!line.empty()) line.push_back({x, line.back().y});
    if (line.empty() || line.back().y != y) line.push_back({x, y});
  }
  ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()), to_u32(curve.color), 0,
                                          ui.px(1.7f));
}

/// A line across the diagram with its name at the foot, to the right or the left of it.
void upright(const Ui& ui, const Frame& frame, double delta, Rgb color, const char* name, bool dashed,
             bool left, int row) {
  if (delta < frame.least * 0.999 || delta > frame.most * 1.001) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = std::round(frame.x(delta)), dash = ui.px(4);
  for (float y = frame.low.y; y < frame.high.y; y += dashed ? 2 * dash : frame.high.y - frame.low.y)
    list.AddLine({x, y}, {x, std::min(dashed ? y + dash : frame.high.y, frame.high.y)}, to_u32(color),
                 ui.px(1.5f));
  const float width = widgets::width_of(ui.fonts.small, name);
  const ImVec2 at{left ? x - width - ui.px(4) : x + ui.px(4), frame.low.y + ui.px(2 + 15 * row)};
  list.AddRectFilled({at.x - ui.px(2), at.y}, {at.x + width + ui.px(2), at.y + ui.px(15)},
                     to_u32(ui.colors.panel, 0.8f), ui.px(3));
  widgets::draw_text(list, ui.fonts.small, at, to_u32(color), name);
}

void grid(const Ui& ui, const Frame& frame, double edge) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr double decade = 10;
  const float none = frame.y(0);
  widgets::draw_text(list, ui.fonts.small, {frame.low.x - ui.px(14), none - ui.px(8)},
                     to_u32(ui.colors.quiet), "0");
  for (double n = 1; n <= frame.largest; n *= decade) {
    const float y = frame.y(n);
    list.AddLine({frame.low.x, y}, {frame.high.x, y}, to_u32(ui.colors.line));
    const std::string text = grouped(static_cast<std::size_t>(n));
    const float width = widgets::width_of(ui.fonts.small, text);
    widgets::draw_text(list, ui.fonts.small, {frame.low.x - width - ui.px(6), y - ui.px(8)},
                       to_u32(ui.colors.quiet), text);
  }
  // 1, 2 and 5 of each decade, in percent of the longest edge.
  float free_from = frame.low.x;
  const double first = 100 * frame.least / edge;
  for (double d = std::pow(decade, std::floor(std::log10(first))); d * edge / 100 <= frame.most; d *= decade)
    for (const double part : {1.0, 2.0, 5.0}) {
      const double delta = part * d * edge / 100;
      if (delta < frame.least || delta > frame.most) continue;
      const float x = frame.x(delta);
      list.AddLine({x, frame.high.y}, {x, frame.high.y + ui.px(4)}, to_u32(ui.colors.quiet, 0.7f));
      const std::string text = general(part * d, 4) + " %";
      const float width = widgets::width_of(ui.fonts.small, text);
      if (x - width / 2 < free_from) continue;
      widgets::draw_text(list, ui.fonts.small, {x - width / 2, frame.high.y + ui.px(4)},
                         to_u32(ui.colors.quiet), text);
      free_from = x + width / 2 + ui.px(8);
    }
}

void shade(const Ui& ui, const DeltaStudy& study, const Frame& frame) {
  if (!study.found()) return;
  const float from = frame.x(study.least), to = frame.x(study.most);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({from, frame.low.y}, {to, frame.high.y}, to_u32(ui.colors.good, 0.13f));
  const char* text = study.insides.size() > 1 ? "the insides are apart" : "one deep inside";
  const float width = widgets::width_of(ui.fonts.small, text);
  if (to - from > width + ui.px(12))
    widgets::draw_text(list, ui.fonts.small,
                       {(from + to - width) / 2, frame.low.y + 0.45f * (frame.high.y - frame.low.y)},
                       to_u32(ui.colors.good_text), text);
}

/// The handle of the δ at which Ω is shown; a drag anywhere in the diagram moves it.
void handle(Ui& ui, const Frame& frame, double run_delta) {
  WindowState& m = ui.window;
  const auto range = m.preview_range();
  ImGui::SetCursorScreenPos(frame.low);
  ImGui::InvisibleButton("delta", {frame.high.x - frame.low.x, frame.high.y - frame.low.y});
  if (range) {
    // Beyond what the grid holds nothing can be shown.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float end = frame.x((*range)[1]);
    if (end < frame.high.x - 1)
      list.AddRectFilled({end, frame.low.y}, frame.high, to_u32(ui.colors.panel, 0.55f));
    if (ImGui::IsItemActive())
      m.preview_delta = std::clamp(frame.delta_at(ImGui::GetIO().MousePos.x), (*range)[0], (*range)[1]);
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    widgets::tip(ui, "δ",
                 "Drag: Ω is shown at that tolerance at once. The run keeps its own until it is taken.");
  const double shown = m.preview_delta.value_or(run_delta);
  const float x = frame.x(shown), r = ui.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = to_u32(ui.colors.accent);
  if (m.preview_delta) list.AddLine({x, frame.low.y}, {x, frame.high.y}, color, ui.px(2));
  list.AddTriangleFilled({x - r, frame.high.y + r * 1.3f}, {x + r, frame.high.y + r * 1.3f},
                         {x, frame.high.y}, color);
}

void legend(const Ui& ui, std::span<const Curve> curves, ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Curve& curve : curves) {
    list.AddLine({at.x, at.y + ui.px(8)}, {at.x + ui.px(16), at.y + ui.px(8)}, to_u32(curve.color), ui.px(2));
    widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(21), at.y}, to_u32(ui.colors.text, 0.9f),
                       curve.name);
    at.x += ui.px(21 + 16) + widgets::width_of(ui.fonts.small, curve.name);
  }
}

/// What Ω is at the δ shown, and what can be done with it.
void figures(Ui& ui, const Scene& scene, std::span<const Curve> curves) {
  const WindowState& m = ui.window;
  const DeltaStudy& study = *scene.study;
  const double shown = m.preview_delta.value_or(scene.delta);
  widgets::value_row(ui, m.preview_delta ? "δ shown" : "δ of the run",
                     short_number(shown) + "   " + percent_text(shown, scene.longest_edge),
                     ui.colors.accent_text);
  if (const DeltaStudy::Step* step = step_at(study, shown))
    for (const Curve& curve : curves)
      widgets::value_row(ui, curve.name, grouped(step->*(curve.value)), curve.color);
  if (study.found()) {
    if (widgets::link_row(
            ui, "opening", "opens below", percent_text(study.least, scene.longest_edge),
            "Below it the inside is joined with the outside. Click goes to where it opens first: "
            "a gap, or a thin place."))
      ui.commands.post("look-at-place", {"opening"});
    if (widgets::link_row(ui, "closing", "closes above", percent_text(study.most, scene.longest_edge),
                          "Beyond it an inside is closed up. Click goes to the first one."))
      ui.commands.post("look-at-place", {"closing"});
  } else {
    widgets::quiet_text(ui, "At no δ does Ω enclose something that lasts.", true);
  }
  ImGui::Dummy({0, ui.px(2)});
  const float gap = ui.px(6), proposed = ui.px(76), back = ui.px(52);
  if (study.found()) {
    if (widgets::plain_button(ui, "Proposed", true, proposed, ui.px(26)))
      ui.commands.post("set", {"preview_delta", "proposed"});
    widgets::tip(ui, "Proposed δ",
                 percent_text(study.proposed, scene.longest_edge) +
                     " of the longest edge: a little above where the inside opens, with few components.");
    ImGui::SameLine(0, gap);
  }
  if (widgets::plain_button(ui, "Back", m.preview_delta.has_value(), back, ui.px(26)))
    ui.commands.post("set", {"preview_delta", "off"});
  widgets::tip(ui, "Back to the run's δ", "Ω is shown as the run has it.");
  ImGui::SameLine(0, gap);
  const float rest = ImGui::GetContentRegionAvail().x;
  if (m.preview_delta ? widgets::primary_button(ui, "Run with this δ", true, rest)
                      : widgets::plain_button(ui, "Run with this δ", false, rest, ui.px(26)))
    ui.commands.post("take-delta");
}

} // namespace

void tolerance_tab(Ui& ui) {
  const auto& scene = ui.window.run.scene;
  if (!scene || !scene->study || scene->study->curve.size() < 2) {
    widgets::quiet_text(ui,
                        "Which tolerances suit is studied where the input does not say what is inside: of "
                        "points, and of triangles with --tolerance auto.",
                        true);
    return;
  }
  const DeltaStudy& study = *scene->study;
  const std::array<Curve, 3> curves{
      {{"components of Ω", &DeltaStudy::Step::components, ui.colors.accent_text},
       {"regions around it", &DeltaStudy::Step::regions, ui.colors.warning_text},
       {"deep insides", &DeltaStudy::Step::deep, ui.colors.good_text}}};
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float side = ui.px(270);
  if (room.x < side + ui.px(200) || room.y < ui.px(90)) return;
  std::size_t largest = 10;
  for (const DeltaStudy::Step& step : study.curve)
    for (const Curve& curve : curves) largest = std::max(largest, step.*(curve.value));
  const Frame frame{{origin.x + ui.px(44), origin.y + ui.px(22)},
                    {origin.x + room.x - side - ui.px(16), origin.y + room.y - ui.px(24)},
                    study.curve.front().delta,
                    study.curve.back().delta,
                    static_cast<double>(largest)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(frame.low, frame.high, to_u32(ui.colors.ground, 0.6f), ui.px(4));
  legend(ui, curves, {frame.low.x, origin.y});
  grid(ui, frame, scene->longest_edge);
  list.PushClipRect({frame.low.x - ui.px(1), frame.low.y}, {frame.high.x + ui.px(1), frame.high.y}, true);
  shade(ui, study, frame);
  for (const Curve& curve : curves) steps(ui, study, frame, curve);
  upright(ui, frame, study.least, ui.colors.quiet, "opens", true, true, 0);
  upright(ui, frame, study.most, ui.colors.quiet, "closes", true, false, 0);
  if (study.found()) upright(ui, frame, study.proposed, ui.colors.good_text, "proposed", true, false, 1);
  upright(ui, frame, scene->delta, ui.colors.selection, "run", false, false, 2);
  list.PopClipRect();
  handle(ui, frame, scene->delta);
  ImGui::SetCursorScreenPos({origin.x + room.x - side, origin.y});
  ImGui::BeginChild("figures", {side, room.y});
  ImGui::PushFont(ui.fonts.small);
  figures(ui, *scene, curves);
  ImGui::PopFont();
  ImGui::EndChild();
}

} // namespace isoscope::panels
