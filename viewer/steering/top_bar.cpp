// Its parts from left to right.
#include "steering/steering.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace isoscope::panels {
namespace {

/// Below this width of the window, in units of the interface, the menus are one.
constexpr float wide_enough = 1180;

void menu_entry(Ui& ui, const Command& command) {
  const std::string key = command.keys.empty() ? "" : text(command.keys.front());
  if (ImGui::MenuItem(command.title.c_str(), key.c_str(), command.is_checked(), command.is_enabled()))
    ui.commands.post(command.name);
  widgets::tip(ui, {}, command.help);
}

void recent_files(Ui& ui) {
  const auto& recent = ui.window.settings.recent;
  if (!ImGui::BeginMenu("Recent", !recent.empty())) return;
  for (const std::string& file : recent)
    if (ImGui::MenuItem(file.c_str())) ui.commands.post("open", {file});
  ImGui::EndMenu();
}

/// The entries of a menu, with a line between groups.
void entries(Ui& ui, std::string_view menu) {
  std::optional<int> group;
  for (const Command& command : ui.table.all()) {
    if (command.menu != menu) continue;
    if (group && *group != command.group) ImGui::Separator();
    group = command.group;
    menu_entry(ui, command);
    if (command.name == "gallery") recent_files(ui);
  }
}

/// A word of the bar that opens what `draw` puts into a popup. `opens`: it was asked for by a key.
template <class Draw> void bar_word(Ui& ui, const char* id, const std::string& label, bool opens, Draw draw) {
  const ImVec2 extent = widgets::text_size(label), at = ImGui::GetCursorScreenPos();
  const float width = extent.x + ui.px(16), high = ui.px(28);
  ImGui::PushID(id);
  const bool pressed = ImGui::InvisibleButton("menu", {width, high});
  const bool was_open = ImGui::IsPopupOpen("entries"), hovered = ImGui::IsItemHovered();
  if (pressed || opens) ImGui::OpenPopup("entries");
  // With one of them open the mouse alone goes on to the next.
  const bool another = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (was_open || (hovered && !another))
    list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.hover), ui.px(5));
  widgets::draw_text(list, ui.fonts.ui, {at.x + ui.px(8), at.y + (high - extent.y) / 2},
                     to_u32(ui.colors.text, 0.92f), label);
  ImGui::SetNextWindowPos({at.x, at.y + high + ui.px(4)});
  if (ImGui::BeginPopup("entries")) {
    ui.window.menu = id;
    // The next one was asked for by a key.
    if (!ui.window.open_menu.empty() && !opens) ImGui::CloseCurrentPopup();
    draw();
    ImGui::EndPopup();
  }
  ImGui::PopID();
  ImGui::SameLine(0, 0);
}

void menus(Ui& ui, bool wide) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(8)});
  const std::string asked = ui.window.open_menu;
  ui.window.menu.clear();
  if (wide) {
    for (const std::string_view name : menu_names)
      bar_word(ui, name.data(), std::string(name), asked == name, [&] { entries(ui, name); });
  } else {
    bar_word(ui, "all", std::string(icon::layers) + "  Menu", !asked.empty(), [&] {
      for (const std::string_view name : menu_names) {
        if (asked == name) ImGui::OpenPopup(name.data());
        if (ImGui::BeginMenu(name.data())) {
          ui.window.menu = name;
          entries(ui, name);
          ImGui::EndMenu();
        }
      }
    });
  }
  ImGui::PopStyleVar();
  ui.window.open_menu.clear();
}

/// Returns the width it took.
void model_name(Ui& ui, float room) {
  const WindowState& m = ui.window;
  std::string name = m.run.scene && m.run.scene->input ? m.run.scene->input->name
                     : m.run.input                     ? m.run.input->name
                                                       : m.run.parameters.input;
  if (name.empty()) name = "no model";
  const bool automatic = m.run.parameters.tolerance.automatic && m.run.scene;
  std::string delta;
  if (automatic)
    delta = "δ " + short_number(100 * m.run.scene->delta / m.run.scene->longest_edge) + "%, found";
  else if (m.run.scene)
    delta = "δ " + (m.run.scene->input->gives_volume() ? general(m.run.scene->delta, 4)
                                                       : m.run.parameters.tolerance.text());
  else if (!m.run.parameters.input.empty() && m.run.parameters.inside.empty())
    delta = "δ " + m.run.parameters.tolerance.text();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushFont(ui.fonts.mono);
  const float delta_width = widgets::text_size(delta).x;
  ImGui::PopFont();
  ImGui::PushFont(ui.fonts.bold);
  name = widgets::fitted(name, std::max(room - delta_width - ui.px(8), ui.px(40)));
  const ImVec2 extent = widgets::text_size(name);
  ImGui::PopFont();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float high = ui.px(28);
  widgets::draw_text(list, ui.fonts.bold, {at.x, at.y + (high - extent.y) / 2}, to_u32(ui.colors.text), name);
  widgets::draw_text(list, ui.fonts.mono,
                     {at.x + extent.x + ui.px(8), at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.quiet), delta);
  ImGui::InvisibleButton("model", {extent.x + delta_width + ui.px(8), high});
  widgets::tip(ui, m.run.parameters.input,
               "δ is the tolerance: half the thickness of Ω, in percent of the longest edge of the input's "
               "bounding box or as a length. §2.1");
  ImGui::SameLine(0, ui.px(14));
}

enum class ChipState { left_out, next, running, done };

/// Whether the input has open surfaces, along whose rim Z is cut.
bool is_open(const WindowState& m) {
  return m.run.scene && m.run.scene->volume && m.run.scene->volume->open_sides() != nullptr;
}

/// Without T the improver is alone.
bool has_stage(const WindowState& m, Stage stage) {
  return m.run.parameters.start == FirstZ::delaunay || stage == Stage::improve;
}

ChipState chip_state(const WindowState& m, Stage stage) {
  const RunParameters& p = m.run.parameters;
  const bool asked = !comes_after(stage, p.last_stage()) && (stage != Stage::rim || is_open(m)) &&
                     !p.skipped.at(static_cast<std::size_t>(stage)) && has_stage(m, stage);
  ChipState state = asked ? ChipState::next : ChipState::left_out;
  for (const JournalIndex::StageSpan& span : m.index.stages())
    if (span.stage == stage)
      state = span.open && m.run.phase != SessionPhase::finished ? ChipState::running : ChipState::done;
  return state;
}

/// The sign of the stages from the i-th on, where there is room for it.
void more_stages(Ui& ui, const std::vector<Stage>& stages, std::size_t i, float room) {
  std::string label = "+" + std::to_string(stages.size() - i);
  const std::string in_full = label + (i + 1 == stages.size() ? " stage" : " stages");
  if (widgets::width_of(ui.fonts.small, in_full) + ui.px(14) <= room) label = in_full;
  const float width = widgets::width_of(ui.fonts.small, label) + ui.px(14), high = ui.px(28);
  if (width > room) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID("more");
  if (ImGui::InvisibleButton("stages", {width, high})) ImGui::OpenPopup("entries");
  widgets::draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
                     {at.x + ui.px(7), at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(ImGui::IsItemHovered() ? ui.colors.text : ui.colors.quiet), label);
  std::string rest;
  for (std::size_t k = i; k < stages.size(); ++k)
    rest += (rest.empty() ? "" : ", ") + std::string(words(stages[k]).title);
  widgets::tip(ui, "More stages", rest);
  if (ImGui::BeginPopup("entries")) {
    for (std::size_t k = i; k < stages.size(); ++k)
      if (ImGui::MenuItem(words(stages[k]).title.data()))
        ui.commands.post("stage", {std::string(name(stages[k]))});
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

/// The stages; those that do not fit stand behind a sign.
void stage_chips(Ui& ui, float room) {
  std::vector<Stage> stages(stages_in_order.begin(), stages_in_order.end());
  std::erase_if(stages, [&](Stage s) {
    return s == Stage::setup || (s == Stage::rim && !is_open(ui.window)) || !has_stage(ui.window, s);
  });
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float high = ui.px(28), pad = ui.px(7);
  float used = 0;
  const auto state_shown = ui.window.state();
  const Stage shown = state_shown && state_shown->event ? state_shown->event->stage : Stage::setup;
  const widgets::Font font(ui.fonts.small);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const ChipState state = chip_state(ui.window, stages[i]);
    std::string label(words(stages[i]).title);
    if (state == ChipState::done) label = std::string(icon::check) + " " + label;
    const ImVec2 extent = widgets::text_size(label), at = ImGui::GetCursorScreenPos();
    const float width = extent.x + 2 * pad + (i > 0 ? ui.px(12) : 0);
    // Those that do not fit are counted, and named where the mouse asks.
    const float sign = i + 1 < stages.size() ? ui.px(40) : 0;
    if (used + width + sign > room) {
      more_stages(ui, stages, i, room - used);
      break;
    }
    used += width;
    float x = at.x;
    if (i > 0) {
      widgets::draw_text(list, ui.fonts.small, {x + ui.px(3), at.y + (high - extent.y) / 2},
                         to_u32(ui.colors.quiet, 0.6f), icon::right);
      x += ui.px(12);
    }
    ImGui::PushID(static_cast<int>(i));
    const bool begun = state == ChipState::running || state == ChipState::done;
    if (ImGui::InvisibleButton("stage", {width, high}) && (begun || state == ChipState::next))
      ui.commands.post("stage", {std::string(name(stages[i]))});
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    const ImVec2 low{x, at.y + ui.px(4)}, end{x + extent.x + 2 * pad, at.y + high - ui.px(4)};
    // The stage of the step shown is outlined, the one that the run works at is filled.
    if (state == ChipState::running)
      list.AddRectFilled(low, end, to_u32(ui.colors.accent, 0.22f), ui.px(10));
    else if (hovered && begun)
      list.AddRectFilled(low, end, to_u32(ui.colors.hover), ui.px(10));
    if (shown == stages[i])
      list.AddRect(low, end, to_u32(stage_color(ui.theme, stages[i])), ui.px(10), 0, ui.px(1.2f));
    const Rgb color = state == ChipState::running ? ui.colors.accent_text
                      : state == ChipState::done  ? ui.colors.good_text
                                                  : ui.colors.quiet;
    widgets::draw_text(list, ui.fonts.small, {x + pad, at.y + (high - extent.y) / 2},
                       to_u32(color, state == ChipState::left_out ? 0.5f : 1.0f), label);
    widgets::tip(ui, "Stage: " + std::string(words(stages[i]).title),
                 std::string(words(stages[i]).help) +
                     (state == ChipState::running ? " Under way; click for its beginning."
                      : state == ChipState::done  ? " Done; click for its beginning."
                      : state == ChipState::next  ? " Not begun; a click lets a held run go on until it does."
                                                  : " Left out of this run."));
    ImGui::SameLine(0, 0);
  }
}

void speed_menu(Ui& ui) {
  const float width = ui.px(62), high = ui.px(28);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("speed", {width, high})) ImGui::OpenPopup("speeds");
  widgets::tip(
      ui, "Speed   , and .",
      "Operations that the play head shows in a second; auto tells a whole run in about ten seconds.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, at.y + ui.px(1)}, {at.x + width, at.y + high - ui.px(1)},
                     to_u32(ImGui::IsItemHovered() ? ui.colors.hover : ui.colors.raised), ui.px(5));
  widgets::draw_text(list, ui.fonts.mono, {at.x + ui.px(8), at.y + (high - ui.fonts.mono->FontSize) / 2},
                     to_u32(ui.colors.text), widgets::speed_text(ui.window.transport.speed()));
  widgets::draw_text(list, ui.fonts.ui, {at.x + width - ui.px(16), at.y + (high - ui.fonts.ui->FontSize) / 2},
                     to_u32(ui.colors.quiet), icon::down);
  ImGui::SetNextWindowPos({at.x, at.y + high + ui.px(4)});
  if (ImGui::BeginPopup("speeds")) {
    for (const double speed : Transport::speeds())
      if (ImGui::MenuItem((widgets::speed_text(speed) + "##" + std::to_string(speed)).c_str(), nullptr,
                          speed == ui.window.transport.speed()))
        ui.window.transport.set_speed(speed);
    ImGui::EndPopup();
  }
}

void live_badge(Ui& ui, float width) {
  const WindowState& m = ui.window;
  const bool following =
      m.transport.mode() == Transport::Mode::following && m.transport.at_live_end(m.live_step());
  const float high = ui.px(28);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("live", {width, high})) ui.commands.post("end");
  widgets::tip(ui, "Follow the live end   End", "Lit while the step shown is the newest one.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{at.x, at.y + ui.px(4)}, end{at.x + width, at.y + high - ui.px(4)};
  // Before the first state there is nothing to follow.
  const bool live = following && m.running() && m.run.phase != SessionPhase::preparing && m.has_state();
  if (live)
    list.AddRectFilled(low, end, to_u32(ui.colors.good, 0.28f), ui.px(10));
  else
    list.AddRect(low, end, to_u32(ui.colors.line), ui.px(10));
  const Rgb color = live ? ui.colors.good_text : following ? ui.colors.text : ui.colors.quiet;
  list.AddCircleFilled({at.x + ui.px(13), at.y + high / 2}, ui.px(3.5f), to_u32(color), 16);
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(22), at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(color), "LIVE");
}

void transport(Ui& ui) {
  const WindowState& m = ui.window;
  widgets::command_button(ui, "first");
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "back");
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "play", m.playing() ? icon::pause : icon::play);
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "step");
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "next-change");
  ImGui::SameLine(0, ui.px(2));
  widgets::command_button(ui, "end");
  ImGui::SameLine(0, ui.px(8));
  speed_menu(ui);
  ImGui::SameLine(0, ui.px(8));
  live_badge(ui, ui.px(58));
}

} // namespace

void top_bar(Ui& ui, const Mosaic& mosaic) {
  const float transport_width = ui.px(6 * 28 + 5 * 2 + 8 + 62 + 8 + 58);
  const float right = ImGui::GetWindowWidth() - ui.px(10) - transport_width;
  const float y = ui.px(6);
  ImGui::SetCursorPos({ui.px(8), y});
  menus(ui, ImGui::GetWindowWidth() >= ui.px(wide_enough));
  float x = ImGui::GetCursorPosX() + ui.px(10);
  if (mosaic.shown()) {
    ImGui::SetCursorPos({x, y + ui.px(6)});
    widgets::bold_text(ui, icon::cubes + std::string("  ") + mosaic.folder()->folder().filename().string());
    return;
  }
  const float room = right - x - ui.px(12);
  ImGui::SetCursorPos({x, y});
  model_name(ui, std::min(room * 0.5f, ui.px(260)));
  x = ImGui::GetCursorPosX();
  ImGui::SetCursorPos({x, y});
  stage_chips(ui, right - x - ui.px(10));
  ImGui::SetCursorPos({right, y});
  transport(ui);
}

} // namespace isoscope::panels
