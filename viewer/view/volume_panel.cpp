// How Ω is drawn: ready looks, and its opacity over d as a curve whose points can be dragged.
#include "view/view.h"

#include "model/words.h"
#include "scene/volume_look.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope::panels {
namespace {

constexpr float most_haze = 1; ///< at the curve's upper rim; scripts may set more
constexpr float handle_radius = 4.5f;

/// Small values have room too.
float curve_height(float haze) {
  return std::sqrt(std::clamp(haze / most_haze, 0.0f, 1.0f));
}

void looks(Ui& ui) {
  std::array<const char*, volume_looks.size()> titles{};
  int chosen = -1;
  const VolumeLook* const now = look_of(ui.window.view);
  for (std::size_t i = 0; i < volume_looks.size(); ++i) {
    titles[i] = volume_looks[i].title.data();
    if (now == &volume_looks[i]) chosen = static_cast<int>(i);
  }
  if (widgets::segmented(ui, "looks", titles, chosen) && chosen >= 0)
    apply(volume_looks[static_cast<std::size_t>(chosen)], ui.window.view);
  widgets::tip(ui, "Looks of Ω",
               "Shell: both boundaries. Fog: a haze around the input. Inner: the inner boundary alone. "
               "Thick: the darker, the more of Ω lies behind.");
}

/// Opacity over d from the outer boundary (left) through the input to the inner one.
void curve(Ui& ui) {
  ViewSettings& view = ui.window.view;
  const std::array<float*, 3> haze{&view.haze_outer, &view.haze_middle, &view.haze_inner};
  const float high = ui.px(44), pad = ui.px(handle_radius + 2);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("haze", {width, high});
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const auto x_of = [&](std::size_t i) {
    return at.x + pad + (width - 2 * pad) * 0.5f * static_cast<float>(i);
  };
  const auto y_of = [&](float value) { return at.y + high - pad - (high - 2 * pad) * curve_height(value); };
  std::size_t near = 0;
  const float mouse = held ? ImGui::GetIO().MouseClickedPos[0].x : ImGui::GetIO().MousePos.x;
  for (std::size_t i = 1; i < haze.size(); ++i)
    if (std::abs(mouse - x_of(i)) < std::abs(mouse - x_of(near))) near = i;
  if (held) {
    const float part = (at.y + high - pad - ImGui::GetIO().MousePos.y) / (high - 2 * pad);
    const float root = std::clamp(part, 0.0f, 1.0f);
    *haze[near] = most_haze * root * root;
  }
  const bool drawn = view.outer.shown();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + high}, to_u32(ui.colors.raised), ui.px(4));
  const float floor = y_of(0);
  // Cool on the outer half, warm on the inner one, as in the picture.
  constexpr int parts = 24;
  for (int i = 0; i < parts; ++i) {
    const auto value = [&](int k) {
      const float s = 2 * static_cast<float>(k) / parts;
      const auto left = static_cast<std::size_t>(std::min(s, 1.0f));
      return std::lerp(*haze[left], *haze[left + 1], s - static_cast<float>(left));
    };
    const auto x = [&](int k) { return std::lerp(x_of(0), x_of(2), static_cast<float>(k) / parts); };
    list.AddQuadFilled({x(i), floor}, {x(i), y_of(value(i))}, {x(i + 1), y_of(value(i + 1))},
                       {x(i + 1), floor},
                       to_u32(i < parts / 2 ? ui.colors.outer : ui.colors.inner, drawn ? 0.55f : 0.2f));
  }
  list.AddLine({x_of(1), at.y + pad}, {x_of(1), floor}, to_u32(ui.colors.line), 1);
  for (std::size_t i = 0; i < haze.size(); ++i)
    list.AddCircleFilled({x_of(i), y_of(*haze[i])},
                         ui.px((hovered || held) && near == i ? handle_radius + 1 : handle_radius),
                         to_u32(drawn ? ui.colors.text : ui.colors.quiet), 16);
  widgets::tip(
      ui, "Haze in Ω",
      "Opacity over d: at the outer boundary (left), at the input, at the inner boundary (right). It "
      "is seen through the outer boundary, and away with it. Now " +
          short_number(static_cast<double>(view.haze_outer)) + ", " +
          short_number(static_cast<double>(view.haze_middle)) + ", " +
          short_number(static_cast<double>(view.haze_inner)) + " a way of δ.");
}

} // namespace

void volume_look(Ui& ui) {
  const ViewSettings& view = ui.window.view;
  if (!view.outer.visible && !view.inner.visible) return;
  ImGui::PushID("volume");
  const float indent = ui.px(50);
  ImGui::Indent(indent);
  {
    const widgets::Font font(ui.fonts.small);
    looks(ui);
  }
  ImGui::Dummy({0, ui.px(3)});
  // The first look is told by the opacities above alone.
  if (view.outer.shown() && look_of(view) != volume_looks.data()) {
    curve(ui);
    ImGui::Dummy({0, ui.px(3)});
  }
  if (const auto grid = ui.window.grid.grid(); grid && grid->coarsened)
    widgets::quiet_text(ui, coarseness_in_words(*grid, ui.window.grid.detail().get()) + ".", true);
  ImGui::Unindent(indent);
  ImGui::PopID();
}

} // namespace isoscope::panels
