// What the window says of an open surface: why a sample is over the rim, and the list of its holes.
#include "ask/investigation.h"

#include "model/words.h"
#include "scene/renderer.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <span>

namespace isoscope::panels {
namespace {

constexpr float loop_units = 44, bridged_units = 24, picture_wide = 58, choice_wide = 128;

std::string delta_text(double length, double delta) {
  return short_number(length / delta) + " δ";
}

/// What of the input's border a place lies on.
std::string border_text(const RimInspection& x) {
  if (!x.edge) return "found by balls";
  const auto [from, to] = *x.edge;
  if (x.at_vertex()) return "vertex " + std::to_string(from);
  return "edge " + std::to_string(from) + " – " + std::to_string(to);
}

/// The loop of a sample's rim; a click flies there.
void loop_link(Ui& ui, const RimInspection& x) {
  if (widgets::link_row(ui, "loop", "hole", std::to_string(x.loop + 1),
                        "The loop of the open rim that is nearest. The camera goes there."))
    ui.commands.post("look-at-hole", {std::to_string(x.loop + 1)});
}

/// A loop, or a stretch, as it lies in its plane.
void draw_loop(const Ui& ui, std::span<const Segment3> pieces, Vec3 center, Vec3 normal, Rgb color,
               ImVec2 low, ImVec2 high) {
  const PlaneAxes axes = plane_axes(normal == Vec3{} ? Vec3{0, 0, 1} : normal);
  const auto flat = [&](Vec3 p) {
    return ImVec2{static_cast<float>(dot(p - center, axes.u)), -static_cast<float>(dot(p - center, axes.v))};
  };
  ImVec2 least{0, 0}, most{0, 0};
  for (const Segment3& s : pieces)
    for (const Vec3& end : s) {
      const ImVec2 p = flat(end);
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  const float wide = std::max(most.x - least.x, 1e-30f), tall = std::max(most.y - least.y, 1e-30f);
  const float scale = std::min((high.x - low.x) / wide, (high.y - low.y) / tall);
  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const ImVec2 shift{(least.x + most.x) / 2, (least.y + most.y) / 2};
  const auto at = [&](Vec3 p) {
    const ImVec2 q = flat(p);
    return ImVec2{middle.x + scale * (q.x - shift.x), middle.y + scale * (q.y - shift.y)};
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Segment3& s : pieces) list.AddLine(at(s[0]), at(s[1]), to_u32(color), ui.px(1.6f));
}

struct StateWords {
  const char* text;
  MarkerShape shape;
};
StateWords words_of(HoleState state) {
  constexpr std::array<StateWords, 3> words{{{"Z is not cut yet", MarkerShape::circle},
                                             {"kept", MarkerShape::ring},
                                             {"filled", MarkerShape::disc}}};
  return words.at(static_cast<std::size_t>(state));
}

void loop_row(Ui& ui, const LoopReport& loop, std::size_t index, bool fills, double delta) {
  widgets::Row row(ui, loop_units, ImGui::GetContentRegionAvail().x - ui.px(choice_wide + 14));
  const std::string number = std::to_string(index + 1);
  if (row.button(index)) ui.commands.post("look-at-hole", {number});
  if (row.hovered()) row.ground(ui.colors.hover);
  row.link();
  widgets::tip(ui, "Hole " + number,
               "A loop of the open rim in its plane. Flatness: how far it reaches from that plane, of its "
               "diameter; up to 0.1 counts as flat. The camera goes there.");
  draw_loop(ui, loop.pieces, loop.loop.center, loop.loop.normal, ui.colors.rim,
            {row.at.x + ui.px(6), row.at.y + ui.px(6)},
            {row.at.x + ui.px(picture_wide), row.at.y + row.high - ui.px(6)});
  const StateWords state = words_of(loop.state);
  row.text(ui.fonts.bold, 72, ui.colors.text, number);
  row.glyph(108, loop.state == HoleState::filled ? ui.colors.zero : ui.colors.rim, state.shape);
  row.text(ui.fonts.small, 120, ui.colors.text, state.text);
  row.text(ui.fonts.small, 236, ui.colors.quiet,
           delta_text(loop.loop.length, delta) + " long, " + delta_text(loop.loop.diameter, delta) + " wide");
  row.text(ui.fonts.small, 410, ui.colors.quiet, "flatness " + short_number(loop.loop.flatness));
  ImGui::SetCursorScreenPos({row.at.x + row.width + ui.px(8), row.at.y + (row.high - ui.px(26)) / 2});
  constexpr std::array<const char*, 2> choices{"keep", "fill"};
  int chosen = fills ? 1 : 0;
  ImGui::PushID(static_cast<int>(index));
  if (widgets::segmented(ui, "choice", choices, chosen, ui.px(choice_wide)))
    ui.commands.post("hole", {number, choices.at(static_cast<std::size_t>(chosen))});
  ImGui::PopID();
  widgets::tip(ui, "Keep or fill",
               "Filled holes are closed between the vertices of their borders, outside of Ω by intent. Takes "
               "effect with a "
               "restart. §4.1");
  row.below();
}

void bridged_row(Ui& ui, const BridgedStretch& stretch, std::size_t index, double delta) {
  widgets::Row row(ui, bridged_units);
  if (row.button(1000000 + index)) ui.commands.post("look-at-hole", {"bridged", std::to_string(index + 1)});
  if (row.hovered()) row.ground(ui.colors.hover);
  row.link();
  widgets::tip(ui, "Bridged",
               "A part of the border before which Ω leaves no gap, so that Z goes on across it. The camera "
               "goes there.");
  row.glyph(108, ui.colors.quiet, MarkerShape::hollow_diamond);
  row.text(ui.fonts.small, 120, ui.colors.quiet, stretch.meets_wall ? "ends on a wall" : "bridged by Ω");
  row.text(ui.fonts.small, 236, ui.colors.quiet, delta_text(stretch.length, delta) + " long");
  row.below();
}

void head(Ui& ui, const RimReport& report) {
  std::string text = counted(report.loops.size(), "hole");
  if (report.count(HoleState::ahead) == 0)
    text += ": " + grouped(report.count(HoleState::kept)) + " kept, " +
            grouped(report.count(HoleState::filled)) + " filled";
  if (!report.bridged.empty())
    text += "; " + counted(report.bridged.size(), "stretch", "stretches") + " of the border bridged by Ω";
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  const auto button = [&](const char* label, const char* what, const char* tip) {
    ImGui::SameLine(0, ui.px(10));
    if (widgets::plain_button(ui, label, true, 0, ui.px(24))) ui.commands.post("hole", {"all", what});
    widgets::tip(ui, label, tip);
  };
  button("Keep all", "keep", "Every hole stays open.");
  button("Fill all", "fill", "Every hole is closed where that meets nothing of the surface.");
  button("Fill flat ones", "flat", "Holes that lie in a plane are closed.");
  const bool differs = !(ui.window.draft.fill == ui.window.run.parameters.fill);
  ImGui::SameLine(0, ui.px(10));
  if (differs ? widgets::primary_button(ui, "Restart", !ui.window.draft.input.empty(), ui.px(90))
              : widgets::plain_button(ui, "Restart", false, ui.px(90), ui.px(24)))
    ui.commands.post("restart");
  widgets::tip(ui, "Restart   Ctrl+R", "Runs again with the holes kept and filled as they are marked here.");
}

} // namespace

void over_rim_details(Ui& ui, const Investigation& asked, const StateSnapshot& s, std::uint32_t id) {
  if (!s.samples || id >= s.samples->over_rim.size())
    return widgets::quiet_text(ui, "This boundary sample is not in the set of this step.", true);
  widgets::heading(ui, icon::hole, "Boundary sample " + grouped(id), "in B: over the open rim, on no side");
  const Vec3 p = s.samples->over_rim[id];
  widgets::value_row(ui, "position", short_number(p.x) + "  " + short_number(p.y) + "  " + short_number(p.z));
  const auto& x = asked.beside_rim();
  if (!x) return;
  const double delta = s.criteria.unit();
  widgets::value_row(ui, "closest point on", "border " + border_text(*x));
  widgets::value_row(ui, "distance to it", delta_text(x->distance, delta));
  loop_link(ui, *x);
  widgets::quiet_text(ui,
                      "Its closest point lies on the border of the input, where Ω leaves it open: on either "
                      "side of the sheet it could be, so that it has no label, and refinement does not ask "
                      "it. §4.1",
                      true);
}

void rim_rows(Ui& ui, const Investigation& asked) {
  const auto& x = asked.beside_rim();
  if (!x) return;
  const double delta = ui.window.run.scene->delta;
  widgets::value_row(ui, "nearest on the rim", border_text(*x));
  widgets::value_row(ui, "distance to the rim", delta_text(x->to_rim, delta));
  loop_link(ui, *x);
  widgets::quiet_text(ui,
                      "Not in B: its closest point, " + delta_text(x->distance, delta) +
                          " away, does not lie on the open rim.",
                      true);
}

void loops_tab(Ui& ui, Investigation& asked) {
  const auto& report = asked.rim_report();
  if (!report) {
    widgets::quiet_text(ui, "The input has no border that Ω leaves open: there are no holes to keep or fill.",
                        true);
    return;
  }
  const widgets::Font font(ui.fonts.small);
  head(ui, *report);
  const double delta = ui.window.run.scene->delta;
  const HoleChoice choice = ui.window.draft.fill.choice();
  if (ImGui::BeginChild("loops", {0, 0})) {
    widgets::rows_in_sight(report->loops.size(), ui.px(loop_units), [&](std::size_t i) {
      const LoopReport& loop = report->loops[i];
      loop_row(ui, loop, i, choice.wants(static_cast<std::uint32_t>(i), loop.loop), delta);
    });
    widgets::rows_in_sight(report->bridged.size(), ui.px(bridged_units),
                           [&](std::size_t i) { bridged_row(ui, report->bridged[i], i, delta); });
  }
  ImGui::EndChild();
}

} // namespace isoscope::panels
