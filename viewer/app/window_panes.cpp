// Where the panes stand in the window, and what is in each.
#include "app/window_panes.h"

#include "app/welcome.h"
#include "steering/steering.h"
#include "ui/key_mark.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "view/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace isoscope {
namespace {

constexpr ImGuiWindowFlags pane_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

struct Pane {
  /// `keyed`: arrows, Enter and letters are its own.
  Pane(const char* name, ImVec2 low, ImVec2 size, bool scrolls, ImVec2 padding, Rgb color,
       const Ui* keyed = nullptr)
      : keyed_(keyed) {
    if (keyed != nullptr && keyed->window.keys_moved) ImGui::SetNextWindowFocus();
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(color));
    const ImGuiWindowFlags flags = scrolls ? pane_flags & ~ImGuiWindowFlags_NoScrollbar
                                           : pane_flags | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin(name, nullptr, keyed != nullptr ? flags & ~ImGuiWindowFlags_NoNavInputs : flags);
  }
  ~Pane() {
    if (keyed_ != nullptr) mark_keys(*keyed_, keyed_->window.keys_moved);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
  }
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;

 private:
  const Ui* keyed_;
};

/// Whether the pane that has the keys is there and nobody went on with the mouse.
bool keeps_keys(const WindowState& m, bool left) {
  const std::array<bool, 4> there{false, left, m.settings.panes.show_right, m.settings.panes.show_bottom};
  return !m.presenter.on && m.overlay == Overlay::none &&
         there.at(static_cast<std::size_t>(m.pane_of_keys)) && !ImGui::IsAnyMouseDown();
}

/// A strip between two panes that is dragged; `value` is the size of one of them in unscaled pixels, `sign`
/// the direction in which it grows.
void splitter(Ui& ui, const char* id, ImVec2 low, ImVec2 size, bool upright, float& value, float sign,
              float least, float most) {
  Pane pane(id, low, size, false, {0, 0}, ui.colors.ground);
  ImGui::InvisibleButton("grip", size);
  const bool hot = ImGui::IsItemActive() || ImGui::IsItemHovered();
  if (hot) {
    ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                                              to_u32(ui.colors.accent, 0.7f));
  }
  if (ImGui::IsItemActive()) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    value = std::clamp(value + sign * (upright ? delta.x : delta.y) / ui.scale, least, std::max(least, most));
  }
}

} // namespace

void WindowPanes::present(Ui& ui, ImVec2 size, bool resting) {
  const bool lesson = model_.lessons.runner.shown() != nullptr;
  const bool covered = model_.overlay != Overlay::none;
  std::optional<panels::PresenterBar> presenter;
  if (!lesson) presenter.emplace(ui, model_.talk, size.x);
  const float bar =
      presenter ? presenter->height(ui) : panels::lesson_caption_height(ui, model_.lessons.runner, size.x);
  float below = 0;
  {
    Pane pane("##view", {0, 0}, {size.x, size.y - bar}, false, {0, 0}, ui.colors.ground);
    views_.draw(ui);
    if (!covered && !model_.comparison.beside()) below = panels::presenter_legend(ui, model_.talk, {0, 0});
  }
  {
    Pane pane("##talk", {0, size.y - bar}, {size.x, bar}, false, {0, 0}, ui.colors.panel);
    if (presenter)
      presenter->draw(ui);
    else
      panels::lesson_caption(ui, model_.lessons.runner);
  }
  if (!covered && resting) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  // Messages wait until the audience is gone.
  if (!covered && !lesson) panels::slide_title(ui, model_.talk.bookmarks, {0, below}, size.x);
  overlays_.draw(ui, size);
}

void WindowPanes::tiles(Ui& ui, float low, float high, float width) {
  PaneLayout& p = model_.settings.panes;
  const float grip = std::max(ui.px(3), 2.0f);
  const float right = ui.px(std::clamp(p.right, 300.0f, std::max(300.0f, 0.45f * width / ui.scale)));
  const float view = std::max(width - right - grip, 1.0f), tall = std::max(high - low, 1.0f);
  {
    Pane pane("##right", {width - right, low}, {right, tall}, false, {ui.px(16), ui.px(12)}, ui.colors.panel);
    panels::mosaic(ui, model_.mosaic);
  }
  splitter(ui, "##grip-right", {width - right - grip, low}, {grip, tall}, true, p.right, -1, 300,
           0.45f * width / ui.scale);
  Pane pane("##view", {0, low}, {view, tall}, false, {0, 0}, ui.colors.ground);
  mosaic_.draw(ui);
}

void WindowPanes::status_bar(Ui& ui, ImVec2 size, float high) {
  Pane pane("##status", {0, size.y - high}, {size.x, high}, false, {0, 0}, ui.colors.ground);
  if (!model_.mosaic.shown()) return panels::status_bar(ui, model_.comparison.history_memory());
  const widgets::Font font(ui.fonts.small);
  ImGui::SetCursorPos({ui.px(12), (high - ui.fonts.small->FontSize) / 2});
  widgets::quiet_text(ui, "a folder of tiles; Ctrl+Shift+T shows the run");
}

void WindowPanes::finish(Ui& ui, ImVec2 size, ImVec2 messages, float room) {
  panels::messages(ui, messages, std::min(room, ui.px(560)));
  overlays_.draw(ui, size);
  model_.keys_moved = false;
}

void WindowPanes::draw(Ui& ui, bool resting) {
  AppModel& m = model_;
  PaneLayout& p = m.settings.panes;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float top = ui.px(40), status = ui.px(24), grip = std::max(ui.px(3), 2.0f), folded = ui.px(0);
  const float width = size.x / ui.scale, height = size.y / ui.scale;
  const bool lesson = m.lessons.runner.on();
  const float left = lesson        ? ui.px(std::clamp(width * 0.32f, 260.0f, 440.0f))
                     : p.show_left ? ui.px(std::min(p.left, width * 0.35f))
                                   : folded;
  const float right = p.show_right ? ui.px(std::min(p.right, width * (lesson ? 0.3f : 0.35f))) : folded;
  const float bottom = p.show_bottom ? ui.px(std::min(p.bottom, height * 0.6f)) : 0;
  const float middle_y = top + grip, bottom_y = size.y - status - bottom;
  const float middle_high = bottom_y - middle_y - (bottom > 0 ? grip : 0);
  const ImVec2 padding{ui.px(14), ui.px(10)};
  if (!keeps_keys(m, left > 0)) m.pane_of_keys = PaneOfKeys::none;
  const auto keyed = [&](PaneOfKeys pane) { return m.pane_of_keys == pane ? &ui : nullptr; };
  if (m.presenter.on) {
    present(ui, size, resting);
    return;
  }

  {
    Pane pane("##top", {0, 0}, {size.x, top}, false, {0, 0}, ui.colors.panel);
    panels::top_bar(ui, m.mosaic);
  }
  if (m.mosaic.shown() && !lesson) {
    tiles(ui, middle_y, size.y - status, size.x);
    status_bar(ui, size, status);
    finish(ui, size, {ui.px(12), middle_y + ui.px(12)}, 0.6f * size.x);
    return;
  }
  mosaic_.rest();
  if (lesson) {
    const float high = std::round((p.show_left ? 0.55f : 1.0f) * middle_high);
    {
      Pane pane("##lesson", {0, middle_y}, {left, high}, false, padding, ui.colors.panel,
                keyed(PaneOfKeys::left));
      panels::lesson(ui, m.lessons.runner);
    }
    if (p.show_left) {
      Pane pane("##left", {0, middle_y + high + grip}, {left, middle_high - high - grip}, true, padding,
                ui.colors.panel);
      panels::parameters_foot(ui, m.steering);
      ImGui::Separator();
      panels::parameters(ui);
      ImGui::Separator();
      panels::layers(ui);
      ImGui::Separator();
      panels::clip_and_filter(ui);
    }
  } else if (left > 0) {
    // What a slider does and the buttons are always in sight, but where nothing else would be.
    const float foot = panels::parameters_foot_height(ui), rest = middle_high - foot - grip;
    const bool pinned = rest >= ui.px(100);
    {
      Pane pane("##left", {0, middle_y}, {left, pinned ? rest : middle_high}, true, padding, ui.colors.panel,
                keyed(PaneOfKeys::left));
      if (!pinned) panels::parameters_foot(ui, m.steering);
      panels::layers(ui);
      ImGui::Separator();
      panels::parameters(ui);
      ImGui::Separator();
      panels::clip_and_filter(ui);
    }
    if (pinned) {
      Pane pane("##parameters", {0, middle_y + rest + grip}, {left, foot}, false, {padding.x, ui.px(8)},
                ui.colors.panel);
      panels::parameters_foot(ui, m.steering);
    }
    splitter(ui, "##grip-left", {left, middle_y}, {grip, middle_high}, true, p.left, 1, 240, width * 0.35f);
  }
  if (right > 0) {
    {
      Pane pane("##right", {size.x - right, middle_y}, {right, middle_high}, true, padding, ui.colors.panel,
                keyed(PaneOfKeys::right));
      panels::inspector(ui, m.probe, m.debug, m.investigation);
    }
    splitter(ui, "##grip-right", {size.x - right - grip, middle_y}, {grip, middle_high}, true, p.right, -1,
             260, width * 0.35f);
  }
  if (bottom > 0) {
    splitter(ui, "##grip-bottom", {0, bottom_y - grip}, {size.x, grip}, false, p.bottom, -1, 110,
             height * 0.6f);
    Pane pane("##bottom", {0, bottom_y}, {size.x, bottom}, false, {ui.px(10), ui.px(4)}, ui.colors.panel,
              keyed(PaneOfKeys::bottom));
    timeline_.draw(ui);
  }
  const float view_x = left > 0 ? left + grip : 0, view_end = right > 0 ? size.x - right - grip : size.x;
  {
    Pane pane("##view", {view_x, middle_y}, {std::max(view_end - view_x, 1.0f), std::max(middle_high, 1.0f)},
              false, {0, 0}, ui.colors.ground);
    views_.draw(ui);
  }
  status_bar(ui, size, status);
  panels::export_progress(ui, m.exports, {view_x, bottom_y - (bottom > 0 ? grip : 0)}, view_end - view_x);
  if (m.overlay == Overlay::none && !lesson && m.has_state())
    panels::coach_marks(ui, {{{{view_x, middle_y}, {view_end - view_x, middle_high}},
                              {{0, bottom_y}, {bottom > 0 ? size.x : 0, bottom}},
                              {{size.x - right, middle_y}, {right, middle_high}}}});
  finish(ui, size, {view_x + ui.px(12), middle_y + ui.px(m.warnings().empty() ? 46 : 78)},
         view_end - view_x - ui.px(24));
}

} // namespace isoscope
