// Clip and filter: what part of the scene is seen, and which tetrahedra.
#include "view/view.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <array>
#include <bit>
#include <cmath>

namespace isoscope::panels {
namespace {

void clip_position(Ui& ui, ClipSettings& clip) {
  const Box3 box = ui.window.scene_bounds();
  if (box.empty()) return;
  const Vec3 middle = box.center();
  const double reach = 0.75 * box.longest_edge();
  const double place = dot(clip.point - middle, clip.normal);
  auto shown = static_cast<float>(reach > 0 ? place / reach : 0);
  if (widgets::slider(ui, "##position", shown, -1, 1, "position %.3f"))
    clip.point += (static_cast<double>(shown) * reach - place) * clip.normal;
  widgets::tip(ui, "Position of the clip", "Along its normal, from one side of the model to the other.");
  if (clip.shape == ClipSettings::Shape::slab || clip.shape == ClipSettings::Shape::ball) {
    auto radius = static_cast<float>(clip.radius / box.longest_edge());
    if (widgets::slider(ui, "##radius", radius, 0.002f, 1,
                        clip.shape == ClipSettings::Shape::ball ? "radius %.3f" : "half width %.3f", true))
      clip.radius = static_cast<double>(radius) * box.longest_edge();
    widgets::tip(ui, "Size of the clip",
                 "Radius of the ball or half the slab, as a fraction of the longest edge.");
  }
}

void normal_buttons(Ui& ui, ClipSettings& clip) {
  constexpr std::array<const char*, 3> axes{"x", "y", "z"};
  constexpr std::array<Vec3, 3> normals{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const float each = (ImGui::GetContentRegionAvail().x - 4 * ui.px(6)) / 5;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool lit = std::abs(dot(clip.normal, normals[i])) > 0.999;
    if (lit) ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.accent_text));
    if (widgets::plain_button(ui, axes[i], true, each)) clip.normal = normals[i];
    if (lit) ImGui::PopStyleColor();
    widgets::tip(ui, std::string("Normal along ") + axes[i]);
    ImGui::SameLine(0, ui.px(6));
  }
  if (widgets::plain_button(ui, (std::string(icon::eye) + "##normal").c_str(), true, each)) {
    const CameraPose& pose = ui.window.camera.pose();
    clip.normal = normalized(ui.window.camera.eye() - pose.target);
  }
  widgets::tip(ui, "Normal towards the eye", "Cuts away what is nearest to the viewer.");
  ImGui::SameLine(0, ui.px(6));
  if (widgets::plain_button(ui, (std::string(icon::flip) + "##flip").c_str(), true, each))
    ui.commands.post("clip-flip");
  widgets::command_tip(ui, "clip-flip");
}

void filter_row(Ui& ui, const char* name, const char* tip, bool& on, std::string_view count) {
  ImGui::PushID(name);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  widgets::toggle(ui, "on", on);
  widgets::tip(ui, name, tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = at.y + ui.px(10);
  widgets::draw_text(list, ui.fonts.small, {at.x + ui.px(38), y - ui.fonts.small->FontSize / 2},
                     to_u32(ui.colors.text), name);
  ImGui::PushFont(ui.fonts.mono);
  const float extent = widgets::text_size(count).x;
  ImGui::PopFont();
  widgets::draw_text(list, ui.fonts.mono, {at.x + width - extent, y - ui.fonts.mono->FontSize / 2},
                     to_u32(ui.colors.quiet), count);
  ImGui::PopID();
}

/// How many tetrahedra carry each flag, by bit.
std::array<std::size_t, 8> flag_counts(const WindowState& m) {
  std::array<std::size_t, 8> counts{};
  const auto state = m.state();
  if (!state) return counts;
  for (const std::uint8_t flags : state->tet_flags)
    if ((flags & tet_alive) != 0)
      for (std::size_t bit = 0; bit < counts.size(); ++bit) counts[bit] += (flags >> bit) & 1u;
  return counts;
}

/// Whether the state shown says which tetrahedra carry the flag: what nothing has judged is not none.
bool is_judged(const WindowState& m, std::uint8_t flag) {
  const auto state = m.state();
  if (!state) return false;
  const bool interpolated = state->complex.form == ZeroForm::interpolated;
  if (flag == tet_violates_1) return state->classifies();
  if (flag == tet_violates_2) return interpolated && state->classifies();
  if (flag == tet_violates_3) return interpolated && state->classifies() && state->orientation_judged;
  return true;
}

std::string count_of(const WindowState& m, const std::array<std::size_t, 8>& counts, std::uint8_t flag) {
  return is_judged(m, flag) ? grouped(counts.at(static_cast<std::size_t>(std::countr_zero(flag)))) : "–";
}

} // namespace

void clip_and_filter(Ui& ui) {
  ViewSettings& view = ui.window.view;
  if (widgets::section(ui, "Clip")) {
    ImGui::PushFont(ui.fonts.small);
    constexpr std::array<const char*, 4> shapes{"none", "plane", "slab", "ball"};
    constexpr std::array<const char*, 3> modes{"cut", "whole cells", "straddle"};
    int shape = static_cast<int>(view.clip.shape), mode = static_cast<int>(view.clip.mode);
    if (widgets::segmented(ui, "shape", shapes, shape))
      view.clip.shape = static_cast<ClipSettings::Shape>(shape);
    widgets::tip(ui, "Shape of the clip   X", "Cuts the scene by a plane, keeps a slab, or keeps a ball.");
    if (view.clip.shape != ClipSettings::Shape::none) {
      if (widgets::segmented(ui, "cells", modes, mode))
        view.clip.mode = static_cast<ClipSettings::Mode>(mode);
      widgets::tip(
          ui, "Cells at the cut   C",
          "Cut them, keep those whole that have a part inside, or show only those that straddle the cut.");
    }
    ImGui::PopFont();
    if (view.clip.shape != ClipSettings::Shape::none || view.mode != ViewMode::scene) {
      clip_position(ui, view.clip);
      normal_buttons(ui, view.clip);
    }
    ImGui::Dummy({0, ui.px(4)});
  }
  if (!widgets::section(ui, "Tetrahedra", true)) return;
  TetFilter& f = view.tets;
  const auto counts = flag_counts(ui.window);
  filter_row(ui, "violate condition 1", "Hold a sample with ε > 1 − α. §2.3", f.violate_1,
             count_of(ui.window, counts, tet_violates_1));
  filter_row(ui, "violate condition 2", "Carry Z and are lower than 2σ/α. §2.3", f.violate_2,
             count_of(ui.window, counts, tet_violates_2));
  filter_row(ui, "violate condition 3", "Carry Z and are misoriented; judged when the play head rests. §2.3",
             f.violate_3, count_of(ui.window, counts, tet_violates_3));
  filter_row(ui, "changed last", "Made by the last operations.", f.changed,
             count_of(ui.window, counts, tet_changed));
  filter_row(ui, "carry Z", "Have vertices of both labels: Γ.", f.carry_zero_set,
             count_of(ui.window, counts, tet_heterogeneous));
  filter_row(ui, "all", "Every tetrahedron inside the bounding box.", f.all,
             count_of(ui.window, counts, tet_alive));
  filter_row(ui, "at the bounding box", "Also those with a corner of the loose bounding box. §2.2", f.box,
             count_of(ui.window, counts, tet_box));
  const auto state = ui.window.state();
  if (state && state->complex.form == ZeroForm::embedded) {
    constexpr std::array<const char*, 3> sides{"both sides", "outer", "inner"};
    int side = static_cast<int>(f.sides);
    ImGui::PushFont(ui.fonts.small);
    if (widgets::segmented(ui, "sides", sides, side)) f.sides = static_cast<TetFilter::Sides>(side);
    ImGui::PopFont();
    widgets::tip(ui, "Sides of Z", "Tetrahedra on both sides of Z, or on one. §2.4.2");
    filter_row(ui, "tint by side",
               "Tetrahedra outside of Z grey, inside in sand; rooms in their own colours.", view.side_tint,
               count_of(ui.window, counts, tet_negative) + " inner");
  }
  auto recent = static_cast<int>(f.recent);
  ImGui::PushFont(ui.fonts.mono);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##recent", &recent, 1, 1000, "last %d operations",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
    f.recent = static_cast<std::uint32_t>(recent);
  ImGui::PopFont();
  widgets::tip(ui, "How far back “changed” reaches", "Operations before the step shown, 1 to 1,000.");
  widgets::slider(ui, "##shrink", f.shrink, 0.1f, 1, "display shrink %.2f");
  widgets::tip(ui, "Display shrink   [ and ]",
               "Size of a tetrahedron on screen about its centroid; not condition 3's factor.");
  ImGui::Dummy({0, ui.px(6)});
}

} // namespace isoscope::panels
