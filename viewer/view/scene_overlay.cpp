// Drawn with the interface's own lists, so that it is crisp at any scale.
#include "view/scene_overlay.h"

#include "journal/describe.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "scene/overlay.h"
#include "scene/pick_geometry.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::overlay {
namespace {

void pill(const Ui& ui, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // Nothing shows through: in a split view the rim of its halves would run through words.
  list.AddRectFilled(low, high, to_u32(ui.colors.panel), ui.px(6));
  list.AddRect(low, high, to_u32(ui.colors.line, 0.9f), ui.px(6));
}

std::string pick_line(const WindowState& m, const Pick& pick) {
  const auto state = m.state();
  if (!state) return {};
  switch (pick.kind) {
  case Pick::Kind::vertex:
    if (pick.id < state->complex.vertices.size())
      return "vertex " + grouped(pick.id) + "   F = " + short_number(state->complex.vertices[pick.id].value);
    break;
  case Pick::Kind::edge:
    return "edge " + grouped(pick.id) + " – " + grouped(pick.other);
  case Pick::Kind::point:
    return "point " + grouped(pick.id);
  case Pick::Kind::over_rim:
    return "boundary sample " + grouped(pick.id) + "   over the rim, on no side";
  case Pick::Kind::facet:
    return "facet " + grouped(pick.id);
  case Pick::Kind::tet:
    return "tetrahedron " + grouped(pick.id) +
           (state->complex.form != ZeroForm::embedded || pick.id >= state->complex.tets.size()
                ? ""
                : "   " + side_text(state->complex.tets[pick.id].side, m.has_rooms()) + " side");
  case Pick::Kind::sample:
    if (state->classifies() && pick.id < state->errors.size())
      return "sample " + grouped(pick.id) +
             "   ε = " + short_number(static_cast<double>(state->errors[pick.id]));
    if (!state->classifies())
      return "sample " + grouped(pick.id) +
             (state->complex.form == ZeroForm::free ? "   not classified" : "   not judged yet");
    break;
  case Pick::Kind::none:
    break;
  }
  return {};
}

} // namespace

void mode_switch(Ui& ui, ImVec2 corner, float room) {
  constexpr std::array<const char*, 3> whole{"3D", "Section", "Split"}, brief{"3D", "2D", "Both"};
  constexpr std::array<const char*, 3> commands{"scene", "section", "split"};
  const float widest = ui.px(192), width = std::min(widest, room - ui.px(20));
  if (width < ui.px(90)) return;
  const auto& labels = width < widest - ui.px(30) ? brief : whole;
  ImGui::SetCursorScreenPos({corner.x - width - ui.px(10), corner.y + ui.px(10)});
  int chosen = static_cast<int>(ui.window.view.mode);
  const widgets::Font font(ui.fonts.small);
  pill(ui, ImGui::GetCursorScreenPos(), {corner.x - ui.px(10), corner.y + ui.px(36)});
  if (widgets::segmented(ui, "mode", labels, chosen, width))
    ui.commands.post(commands.at(static_cast<std::size_t>(chosen)));
}

void axes(const Ui& ui, const Camera& camera, ImVec2 low, ImVec2 size) {
  // Before an audience the legend comes first.
  if (!ui.window.view.axes || size.y < ui.px(ui.window.presenter.on ? 300 : 160)) return;
  const glm::mat4 view = camera.view();
  const ImVec2 origin{low.x + ui.px(46), low.y + size.y - ui.px(46)};
  const float reach = ui.px(28);
  struct Axis {
    glm::vec4 direction;
    const char* name;
    Rgb color;
  };
  std::array<Axis, 3> all{{{view * glm::vec4(1, 0, 0, 0), "x", 0xE0705A},
                           {view * glm::vec4(0, 1, 0, 0), "y", 0x4FB98A},
                           {view * glm::vec4(0, 0, 1, 0), "z", 0x5BA4E6}}};
  std::sort(all.begin(), all.end(),
            [](const Axis& a, const Axis& b) { return a.direction.z < b.direction.z; });
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Axis& axis : all) {
    const ImVec2 end{origin.x + axis.direction.x * reach, origin.y - axis.direction.y * reach};
    const float strength = axis.direction.z < -0.2f ? 0.5f : 1.0f;
    list.AddLine(origin, end, to_u32(axis.color, strength), ui.px(2));
    const float r = ui.px(8);
    const ImVec2 tip{origin.x + axis.direction.x * (reach + r), origin.y - axis.direction.y * (reach + r)};
    const float width = widgets::width_of(ui.fonts.small, axis.name);
    widgets::draw_text(list, ui.fonts.small, {tip.x - width / 2, tip.y - ui.fonts.small->FontSize / 2},
                       to_u32(axis.color, strength), axis.name);
  }
}

void scale_bar(const Ui& ui, double delta, ImVec2 low, ImVec2 size, double height) {
  if (!ui.window.view.scale_bar || delta <= 0 || height <= 0) return;
  const double pixels_per_delta = delta * static_cast<double>(size.y) / height;
  const double wanted = ui.px(110) / pixels_per_delta;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double multiple = wanted / decade >= 5 ? 5 * decade : wanted / decade >= 2 ? 2 * decade : decade;
  const auto length = static_cast<float>(multiple * pixels_per_delta);
  if (!(length > ui.px(8)) || length > size.x / 2) return;
  const std::string label =
      (multiple >= 1 ? grouped(static_cast<std::size_t>(multiple)) : short_number(multiple)) + " δ";
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 right{low.x + size.x - ui.px(18), low.y + size.y - ui.px(18)};
  const ImU32 color = to_u32(ui.colors.text, 0.9f);
  const float tick = ui.px(4);
  list.AddRectFilled({right.x - length - ui.px(8), right.y - ui.px(24)},
                     {right.x + ui.px(8), right.y + ui.px(8)}, to_u32(ui.colors.ground, 0.6f), ui.px(5));
  list.AddLine({right.x - length, right.y}, right, color, ui.px(1.5f));
  list.AddLine({right.x - length, right.y - tick}, {right.x - length, right.y + tick}, color, ui.px(1.5f));
  list.AddLine({right.x, right.y - tick}, {right.x, right.y + tick}, color, ui.px(1.5f));
  widgets::draw_text(
      list, ui.fonts.small,
      {right.x - length / 2 - widgets::width_of(ui.fonts.small, label) / 2, right.y - ui.px(20)}, color,
      label);
}

float sentence(const Ui& ui, const Event* event, std::string text, ImVec2 low, float room, int lines) {
  if (room < ui.px(100)) return 0;
  ImGui::PushFont(ui.fonts.small);
  text = widgets::fitted(text, room, lines);
  const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
  ImGui::PopFont();
  const ImVec2 at{low.x + ui.px(12), low.y + ui.px(10)};
  const float text_width = text_size.x, high = ui.px(26) + text_size.y - ui.fonts.small->FontSize;
  pill(ui, at, {at.x + text_width + ui.px(30), at.y + high});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool rejected = event && event->kind == EventKind::rejection;
  const Rgb color = !event     ? ui.colors.quiet
                    : rejected ? words(event->reason).color
                    : event->condition != Condition::none
                        ? condition_color(ui.theme, static_cast<int>(event->condition))
                        : stage_color(ui.theme, event->stage);
  widgets::glyph(ui, {at.x + ui.px(13), at.y + ui.px(13)}, 4.5f, color,
                 rejected ? words(event->reason).shape : MarkerShape::disc);
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(22), at.y + (high - text_size.y) / 2},
                     to_u32(ui.colors.text), text);
  return high;
}

float caption(const Ui& ui, ImVec2 low, ImVec2 size) {
  const WindowState& m = ui.window;
  const auto state = m.state();
  if (m.input_alone() || !state || !m.run.journal || m.run.journal->events().empty()) return 0;
  // A rejection that was chosen is no operation: it is told instead of the one that led here.
  const auto chosen = m.selection.event ? m.selected_event() : std::nullopt;
  const Event* event = chosen ? &m.run.journal->events()[*chosen] : state->event ? &*state->event : nullptr;
  std::string text = event ? describe(*m.run.journal, *event)
                     : m.run.parameters.start == FirstZ::delaunay
                         ? "Samples on both boundaries of Ω, before T is there."
                         : "Both boundaries of Ω, before the first Z is there.";
  const double enlarged = move_scale(*state, pixels_per_unit(m.camera, static_cast<double>(size.y)) /
                                                 static_cast<double>(ui.scale));
  if (enlarged > 1 && m.view.highlight.shown())
    text += " (moves drawn up to " + grouped(static_cast<std::size_t>(enlarged)) + " times as long)";
  if (m.view.moment == Moment::before) text = "before · " + text;
  const float beside = size.x - ui.px(192 + 10 + 24 + 40);
  if (beside >= ui.px(200)) {
    const int lines = size.y < ui.px(240) ? 1 : 3;
    return std::max(0.0f, sentence(ui, event, std::move(text), low, beside, lines) - ui.px(26));
  }
  if (size.y < ui.px(240)) return 0; // the model comes first
  const float high =
      sentence(ui, event, std::move(text), {low.x, low.y + ui.px(32)}, size.x - ui.px(24 + 30), 3);
  return ui.px(32) + std::max(0.0f, high - ui.px(26));
}

void preview(const Ui& ui, ImVec2 low, ImVec2 size) {
  const WindowState& m = ui.window;
  if (!m.preview_delta || !m.run.scene) return;
  const std::string text = "Ω at δ = " + short_number(100 * *m.preview_delta / m.run.scene->longest_edge) +
                           " %, " + short_number(*m.preview_delta / m.run.scene->delta) +
                           " of the run's; Z and samples are the run's";
  const float width = widgets::width_of(ui.fonts.small, text), high = ui.px(26);
  if (width + ui.px(48) > size.x) return;
  const ImVec2 at{low.x + ui.px(12), low.y + ui.px(42)};
  pill(ui, at, {at.x + width + ui.px(24), at.y + high});
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {at.x + ui.px(12), at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(ui.colors.accent_text), text);
}

void section_caption(const Ui& ui, ImVec2 low, ImVec2 size) {
  const Vec3 n = ui.window.view.clip.normal;
  std::string name;
  for (int i = 0; i < 3; ++i)
    if (std::abs(n[i]) > 0.9999) name = std::string(1, static_cast<char>('x' + i));
  if (name.empty())
    name = "(" + short_number(n.x) + ", " + short_number(n.y) + ", " + short_number(n.z) + ")";
  const std::string text = "section, normal " + name;
  const float room = size.x - ui.px(14 + 150); // beside the scale bar
  if (room < ui.px(70)) return;
  const std::string lines = widgets::broken_lines(ui.fonts.small, text, room);
  const float high = widgets::height_of(ui.fonts.small, lines);
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {low.x + ui.px(14), low.y + size.y - ui.px(14) - high}, to_u32(ui.colors.quiet), lines);
}

void hover_tip(const Ui& ui) {
  const std::string line = pick_line(ui.window, ui.window.selection.hovered);
  if (line.empty()) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(5)});
  ImGui::BeginTooltip();
  ImGui::PushFont(ui.fonts.small);
  ImGui::TextUnformatted(line.c_str());
  ImGui::PopFont();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void invitation(Ui& ui, ImVec2 low, ImVec2 size) {
  const WindowState& m = ui.window;
  const bool sampled = m.state() && m.state()->samples; // before it failed: that is to be seen
  const bool nothing =
      m.run.phase == SessionPhase::idle || (m.run.phase == SessionPhase::failed && !m.run.scene && !sampled);
  if (!nothing || size.x < ui.px(300)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{low.x + size.x / 2, low.y + size.y / 2};
  const char* title = "Drop a model here";
  const char* note = "A surface: OFF, OBJ, PLY, STL · points: XYZ, PLY · a volume: two surfaces, or a grid";
  widgets::draw_text(list, ui.fonts.title,
                     {middle.x - widgets::width_of(ui.fonts.title, title) / 2, middle.y - ui.px(56)},
                     to_u32(ui.colors.text), title);
  widgets::draw_text(list, ui.fonts.ui,
                     {middle.x - widgets::width_of(ui.fonts.ui, note) / 2, middle.y - ui.px(24)},
                     to_u32(ui.colors.quiet), note);
  const float width = ui.px(120), gap = ui.px(10);
  ImGui::SetCursorScreenPos({middle.x - width - gap / 2, middle.y + ui.px(8)});
  if (widgets::primary_button(ui, "Open…", true, width)) ui.commands.post("open");
  ImGui::SetCursorScreenPos({middle.x + gap / 2, middle.y + ui.px(8)});
  if (widgets::plain_button(ui, "Gallery", true, width)) ui.commands.post("gallery");
}

float progress_box_height(const Ui& ui, bool with_cancel) {
  return ui.px(with_cancel ? 84 : 46);
}

void progress_box(Ui& ui, const std::string& text, double fraction, const char* cancel, ImVec2 at,
                  float width) {
  pill(ui, at, {at.x + width, at.y + progress_box_height(ui, cancel != nullptr)});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = ui.px(14);
  widgets::draw_text(list, ui.fonts.small, {at.x + pad, at.y + ui.px(10)}, to_u32(ui.colors.text), text);
  const ImVec2 bar{at.x + pad, at.y + ui.px(32)};
  const float length = width - 2 * pad, thick = ui.px(5);
  list.AddRectFilled(bar, {bar.x + length, bar.y + thick}, to_u32(ui.colors.line), thick / 2);
  const auto phase = static_cast<float>(std::fmod(ui.window.clock, 1.6) / 1.6);
  const float begin = fraction >= 0 ? 0 : std::max(0.0f, phase * 1.3f - 0.3f),
              end = fraction >= 0 ? static_cast<float>(std::clamp(fraction, 0.02, 1.0))
                                  : std::min(1.0f, phase * 1.3f);
  list.AddRectFilled({bar.x + begin * length, bar.y}, {bar.x + end * length, bar.y + thick},
                     to_u32(ui.colors.accent), thick / 2);
  if (cancel == nullptr) return;
  ImGui::SetCursorScreenPos({at.x + width - pad - ui.px(72), at.y + ui.px(46)});
  if (widgets::plain_button(ui, "Cancel", true, ui.px(72))) ui.commands.post(cancel);
}

void progress(Ui& ui, const ShownRun& m, const char* cancel, ImVec2 low, ImVec2 size) {
  const bool preparing = m.run.phase == SessionPhase::preparing;
  const bool waiting = !preparing && !m.playhead.idle() && !m.state();
  const bool painting = !preparing && m.grid.working();
  if (!preparing && !waiting && !painting) return;
  const bool counted = preparing && !m.shows_recording();
  const std::string text = counted     ? "Preparing: " + m.preparation().words()
                           : preparing ? "Preparing: " + m.run.part
                           : waiting   ? "Reading the journal"
                                       : "Painting Ω";
  const double fraction = counted ? m.preparation().share() : painting ? m.grid.fraction() : -1.0;
  const float width = ui.px(280), high = progress_box_height(ui, preparing);
  const bool empty = preparing && !m.run.input; // else it would cover what there is to be seen
  const ImVec2 at{low.x + (size.x - width) / 2,
                  empty ? low.y + (size.y - high) / 2 : low.y + size.y - high - ui.px(16)};
  progress_box(ui, text, fraction, preparing ? cancel : nullptr, at, width);
}

} // namespace isoscope::overlay
