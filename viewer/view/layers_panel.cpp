// Layers: an eye, a name, an opacity each; and what colours and shapes mean.
#include "view/view.h"

#include "model/words.h"
#include "scene/input_points.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>

namespace isoscope::panels {
namespace {

enum class Swatch { surface, disc, cross, diamond, line, cell, ramp };

struct Row {
  std::string_view layer;
  Swatch swatch;
  Rgb Palette::*color;
};
constexpr Row layer_rows[] = {
    {"outer", Swatch::surface, &Palette::outer},
    {"inner", Swatch::surface, &Palette::inner},
    {"zero", Swatch::surface, &Palette::zero},
    {"good", Swatch::disc, &Palette::good},
    {"bad", Swatch::cross, &Palette::bad},
    {"over-rim", Swatch::diamond, &Palette::rim},
    {"curves", Swatch::line, &Palette::zero},
    {"rim", Swatch::line, &Palette::rim},
    {"dropped", Swatch::surface, &Palette::rim},
    {"tets", Swatch::cell, &Palette::misoriented},
    {"gamma", Swatch::line, &Palette::gamma},
    {"other-zero", Swatch::line, &Palette::other_zero},
    {"highlight", Swatch::line, &Palette::selection},
    {"xray", Swatch::cell, &Palette::kernel},
    {"points", Swatch::ramp, &Palette::quiet},
    {"input", Swatch::surface, &Palette::quiet},
};

ImU32 weight_color32(const Ui& ui, float weight, float strength) {
  const glm::vec3 c = weight_color(ui.theme, weight);
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, strength});
}

/// Whether the scene has what a layer draws.
bool has_layer(const Ui& ui, std::string_view layer) {
  const auto& scene = ui.window.run.scene;
  if (layer == "other-zero") return ui.window.other_state != nullptr;
  if (layer == "points") return scene && scene->points;
  if (layer == "over-rim" || layer == "rim" || layer == "dropped") return ui.window.rim() != nullptr;
  if (layer == "curves") return ui.window.rim() != nullptr || ui.window.has_rooms();
  if (layer == "input") return !scene || !scene->input || !scene->input->triangles.empty();
  return true;
}

void draw_swatch(const Ui& ui, Swatch swatch, Rgb color, ImVec2 middle, float strength) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = ui.px(5);
  const ImU32 c = to_u32(color, strength);
  switch (swatch) {
  case Swatch::surface:
    list.AddRectFilled({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, c, ui.px(3));
    break;
  case Swatch::disc:
    list.AddCircleFilled(middle, r, c, 20);
    break;
  case Swatch::cross:
    list.AddLine({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, c, ui.px(2));
    list.AddLine({middle.x - r, middle.y + r}, {middle.x + r, middle.y - r}, c, ui.px(2));
    break;
  case Swatch::diamond:
    list.AddQuad({middle.x, middle.y - r}, {middle.x + r, middle.y}, {middle.x, middle.y + r},
                 {middle.x - r, middle.y}, c, ui.px(1.5f));
    break;
  case Swatch::ramp:
    for (int i = -1; i <= 1; ++i)
      list.AddCircleFilled({middle.x + static_cast<float>(i) * r * 0.9f, middle.y}, r * 0.5f,
                           weight_color32(ui, 0.5f + 0.5f * static_cast<float>(i), strength), 12);
    break;
  case Swatch::line:
    list.AddLine({middle.x - r, middle.y + r * 0.6f}, {middle.x + r, middle.y - r * 0.6f}, c, ui.px(2));
    break;
  case Swatch::cell:
    list.AddTriangle({middle.x, middle.y - r}, {middle.x - r, middle.y + r * 0.8f},
                     {middle.x + r, middle.y + r * 0.8f}, c, ui.px(1.5f));
    break;
  }
}

/// A slim slider without frame; true while it is dragged.
bool opacity(const Ui& ui, float& value, float width, bool active) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(26), thick = ui.px(4), grab = ui.px(5);
  ImGui::InvisibleButton("opacity", {width, height});
  const bool held = ImGui::IsItemActive();
  if (held) value = std::clamp((ImGui::GetIO().MousePos.x - at.x - grab) / (width - 2 * grab), 0.0f, 1.0f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = at.y + height / 2, x = at.x + grab + value * (width - 2 * grab);
  list.AddRectFilled({at.x + grab, y - thick / 2}, {at.x + width - grab, y + thick / 2},
                     to_u32(ui.colors.line), thick / 2);
  list.AddRectFilled({at.x + grab, y - thick / 2}, {x, y + thick / 2},
                     to_u32(ui.colors.accent, active ? 0.9f : 0.35f), thick / 2);
  const bool hot = held || ImGui::IsItemHovered();
  list.AddCircleFilled({x, y}, hot ? grab + ui.px(1) : grab,
                       to_u32(active ? ui.colors.text : ui.colors.quiet, hot ? 1.0f : 0.85f), 20);
  return held;
}

void layer_row(Ui& ui, const Row& row) {
  const auto names = layer_names();
  const auto name =
      std::find_if(names.begin(), names.end(), [&](const LayerName& l) { return l.name == row.layer; });
  LayerSettings& layer = ui.window.view.*(name->member);
  ImGui::PushID(name->title.data());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, high = ui.px(26), slider = ui.px(84);
  if (ImGui::InvisibleButton("eye", {ui.px(24), high})) {
    // With Ctrl: this one alone, as layer lists elsewhere do.
    if (ImGui::GetIO().KeyCtrl)
      for (const Row& other : layer_rows)
        for (const LayerName& l : names)
          if (l.name == other.layer) (ui.window.view.*(l.member)).visible = l.name == row.layer;
    if (!ImGui::GetIO().KeyCtrl) layer.visible = !layer.visible;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float strength = layer.visible ? 1.0f : 0.35f;
  const float y = at.y + (high - ui.fonts.ui->FontSize) / 2;
  widgets::draw_text(
      list, ui.fonts.ui, {at.x + ui.px(2), y},
      to_u32(ImGui::IsItemHovered() ? ui.colors.accent_text : ui.colors.text, layer.visible ? 0.9f : 0.4f),
      layer.visible ? icon::eye : icon::eye_off);
  widgets::tip(ui, layer.visible ? "Hide" : "Show", "Ctrl-click shows this layer alone.");
  const auto state = ui.window.state();
  const bool unclassified = row.layer == "good" && state != nullptr && !state->classifies();
  draw_swatch(ui, row.swatch, unclassified ? ui.colors.quiet : ui.colors.*(row.color),
              {at.x + ui.px(36), at.y + high / 2}, strength);
  ImGui::SetCursorScreenPos({at.x + ui.px(26), at.y});
  ImGui::InvisibleButton("name", {width - slider - ui.px(30), high});
  const std::string_view title = unclassified ? "Samples, not classified" : name->title;
  widgets::tip(
      ui, title,
      unclassified
          ? "There is no f that classifies the samples of S: T is not there yet, or Z has left it. They "
            "are drawn grey."
          : name->tip);
  ImGui::PushFont(ui.fonts.small);
  const std::string shown = widgets::fitted(title, width - slider - ui.px(54));
  ImGui::PopFont();
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(50), at.y + (high - ui.fonts.small->FontSize) / 2},
                     to_u32(ui.colors.text, layer.visible ? 1.0f : 0.55f), shown);
  ImGui::SetCursorScreenPos({at.x + width - slider, at.y});
  opacity(ui, layer.opacity, slider, layer.visible);
  widgets::tip(ui, "Opacity",
               "From invisible to solid, 0 to 1; now " + short_number(static_cast<double>(layer.opacity)) +
                   ".");
  ImGui::SetCursorScreenPos({at.x, at.y + high});
  ImGui::PopID();
}

/// What the colours of points mean.
void weight_legend(const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + ui.px(50), high = ui.px(34), bar = ui.px(6), shown = ui.px(84);
  const float width = std::max(ImGui::GetContentRegionAvail().x - ui.px(50) - shown - ui.px(8), ui.px(60));
  ImGui::InvisibleButton("weights", {ImGui::GetContentRegionAvail().x, high});
  widgets::tip(
      ui, "Weight of a point",
      "√w/δ: how far its k nearest points spread around their mean. At 0 its ball has the radius δ, at "
      "1 nothing is left of it, and the point is dropped.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int parts = 24;
  for (int i = 0; i < parts; ++i) {
    const float part = static_cast<float>(i) / parts, next = static_cast<float>(i + 1) / parts;
    list.AddRectFilledMultiColor({left + part * width, at.y + ui.px(4)},
                                 {left + next * width, at.y + ui.px(4) + bar}, weight_color32(ui, part, 1),
                                 weight_color32(ui, next, 1), weight_color32(ui, next, 1),
                                 weight_color32(ui, part, 1));
  }
  const float text = at.y + ui.px(5) + bar;
  const auto put = [&](float x, std::string_view words) {
    widgets::draw_text(list, ui.fonts.small, {x, text}, to_u32(ui.colors.quiet), words);
  };
  put(left, "0");
  put(left + (width - widgets::width_of(ui.fonts.small, "√w/δ")) / 2, "√w/δ");
  put(left + width - widgets::width_of(ui.fonts.small, "1"), "1");
  const glm::vec3 c = scene_colors(ui.theme).dropped;
  const ImU32 cross = ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1});
  const float r = ui.px(3.5f), x = left + width + ui.px(20), y = text + ui.px(8);
  list.AddLine({x - r, y - r}, {x + r, y + r}, cross, ui.px(1.7f));
  list.AddLine({x - r, y + r}, {x + r, y - r}, cross, ui.px(1.7f));
  put(x + ui.px(9), "dropped");
}

/// Which good samples are drawn.
void near_switch(Ui& ui) {
  constexpr std::array<const char*, 2> labels{"near the operation", "all of them"};
  const widgets::Font font(ui.fonts.small);
  int chosen = ui.window.view.near_samples ? 0 : 1;
  ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x + ui.px(50), ImGui::GetCursorScreenPos().y});
  if (widgets::segmented(ui, "near", labels, chosen)) ui.commands.post("near-samples");
  widgets::tip(ui, "Good samples in 3D",
               "Only those around the current operation, or all of S. Bad ones are always shown, and the "
               "section shows all that it cuts.");
  ImGui::Dummy({0, ui.px(3)});
}

/// Which colour and hatch is which room.
void room_legend(const Ui& ui) {
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const float left = begin.x + ui.px(50), high = ui.px(22), box = ui.px(18), column = ui.px(82);
  const float right = begin.x + ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at{left, begin.y};
  for (const std::int8_t label : ui.window.side_labels()) {
    if (at.x > left && at.x + column > right) at = {left, at.y + high};
    const float top = at.y + (high - ui.px(14)) / 2;
    widgets::room_swatch(ui, {at.x, top}, {at.x + box, top + ui.px(14)}, label);
    widgets::draw_text(list, ui.fonts.small,
                       {at.x + box + ui.px(6), at.y + (high - ui.fonts.small->FontSize) / 2},
                       to_u32(ui.colors.text), label > 0 ? "outside" : side_text(label, true));
    at.x += column;
  }
  ImGui::InvisibleButton("rooms", {right - begin.x, at.y + high - begin.y});
  widgets::tip(ui, "Rooms",
               "A facet of Z shows the room that lies behind it; its hatch has the colour of the room before "
               "it. §4.2");
}

} // namespace

void layers(Ui& ui) {
  if (!widgets::section(ui, "Layers")) return;
  // Where the samples are hidden as a group none of them is in sight; switching one on shows that one alone.
  ViewSettings& view = ui.window.view;
  const std::array classes{&view.good_samples.visible, &view.bad_samples.visible, &view.over_rim.visible};
  std::array<bool, classes.size()> kept{};
  for (std::size_t i = 0; i < classes.size(); ++i) {
    kept[i] = *classes[i];
    *classes[i] = kept[i] && view.samples.visible;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0});
  for (const Row& row : layer_rows) {
    if (!has_layer(ui, row.layer)) continue;
    layer_row(ui, row);
    if (row.layer == "inner") volume_look(ui);
    if (row.layer == "points" && ui.window.view.points.visible) weight_legend(ui);
    if (row.layer == "good" && ui.window.view.good_samples.visible) near_switch(ui);
    if (row.layer == "zero" && ui.window.view.zero_set.visible && ui.window.has_rooms()) room_legend(ui);
  }
  ImGui::PopStyleVar();
  if (!view.samples.visible) {
    view.samples.visible =
        std::any_of(classes.begin(), classes.end(), [](const bool* shown) { return *shown; });
    if (!view.samples.visible)
      for (std::size_t i = 0; i < classes.size(); ++i) *classes[i] = kept[i];
  }
  ImGui::Dummy({0, ui.px(4)});
}

} // namespace isoscope::panels
