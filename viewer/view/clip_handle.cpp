// A drag of the disc follows the normal on the screen; one of the tip turns the normal in the plane of the
// view.
#include "view/clip_handle.h"

#include "scene/overlay.h"
#include "scene/section_attempt.h"
#include "scene/section_view.h"
#include "ui/widgets.h"
#include "view/section_through.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace isoscope {
namespace {

constexpr float reach = 11, arrow = 58; ///< in units of the interface

bool has_handle(const WindowState& m) {
  using Shape = ClipSettings::Shape;
  const Shape shape = m.view.clip.shape;
  const bool cuts = shape == Shape::plane || shape == Shape::slab;
  return m.view.clip_handle && !m.presenter.on && (cuts || m.view.mode == ViewMode::split) &&
         !m.scene_bounds().empty();
}

/// The handle on the screen, relative to the view.
struct Places {
  Vec3 anchor;         ///< in the scene
  double unit = 0;     ///< scene units a pixel at the anchor
  ImVec2 disc, tip;    ///< pixels
  ImVec2 along{0, -1}; ///< of the normal on the screen, of unit length
  double rate = 0;     ///< pixels a scene unit of the normal
};

std::optional<Places> places(const Ui& ui, ImVec2 size) {
  const WindowState& m = ui.window;
  const ClipSettings& clip = m.view.clip;
  Places p;
  p.anchor = clip_anchor(clip, m.scene_bounds());
  const auto screen = [&](Vec3 q) {
    return project(m.camera, q, static_cast<double>(size.x), static_cast<double>(size.y));
  };
  const CameraPose& pose = m.camera.pose();
  const double depth =
      pose.orthographic ? pose.distance : dot(p.anchor - m.camera.eye(), m.camera.to_world({0, 0, -1}));
  const ScreenPoint disc = screen(p.anchor);
  if (!disc.visible || !(depth > 0)) return std::nullopt;
  p.unit = depth / (pose.distance * pixels_per_unit(m.camera, static_cast<double>(size.y)));
  const double long_as = static_cast<double>(ui.px(arrow)) * p.unit;
  const ScreenPoint tip = screen(p.anchor + long_as * clip.normal);
  if (!tip.visible) return std::nullopt;
  p.disc = {static_cast<float>(disc.x), static_cast<float>(disc.y)};
  p.tip = {static_cast<float>(tip.x), static_cast<float>(tip.y)};
  const double dx = tip.x - disc.x, dy = tip.y - disc.y, pixels = std::hypot(dx, dy);
  p.rate = pixels / long_as;
  if (pixels > 1) p.along = {static_cast<float>(dx / pixels), static_cast<float>(dy / pixels)};
  // Where the normal runs to or from the eye, up moves the plane.
  if (pixels < static_cast<double>(ui.px(12))) {
    p.along = {0, -1};
    p.rate = 1 / p.unit;
  }
  return p;
}

bool near(ImVec2 a, ImVec2 b, float most) {
  return std::hypot(a.x - b.x, a.y - b.y) <= most;
}

} // namespace

bool ClipHandle::update(Ui& ui, ViewArea area, bool hovered) {
  WindowState& m = ui.window;
  hovered_ = Part::none;
  const auto p = has_handle(m) ? places(ui, area.size) : std::nullopt;
  if (!p) {
    dragged_ = Part::none;
    return false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse{io.MousePos.x - area.low.x, io.MousePos.y - area.low.y};
  ClipSettings& clip = m.view.clip;
  if (dragged_ != Part::none) {
    if (!ImGui::IsMouseDown(0)) {
      dragged_ = Part::none;
      return true; // the release picks nothing
    }
    if (dragged_ == Part::disc) {
      const auto along = static_cast<double>(io.MouseDelta.x * p->along.x + io.MouseDelta.y * p->along.y);
      clip.point += along / p->rate * clip.normal;
    } else {
      const Vec3 moved = static_cast<double>(ui.px(arrow)) * p->unit * clip.normal +
                         m.camera.to_world({static_cast<double>(io.MouseDelta.x) * p->unit,
                                            -static_cast<double>(io.MouseDelta.y) * p->unit, 0});
      if (squared_length(moved) > 0) {
        clip.normal = normalized(moved);
        clip.point = p->anchor; // it turns about the handle
      }
    }
    return true;
  }
  if (!hovered) return false;
  hovered_ = near(mouse, p->tip, ui.px(reach))    ? Part::tip
             : near(mouse, p->disc, ui.px(reach)) ? Part::disc
                                                  : Part::none;
  if (hovered_ == Part::none) return false;
  ImGui::SetMouseCursor(hovered_ == Part::tip ? ImGuiMouseCursor_ResizeAll : ImGuiMouseCursor_Hand);
  if (!ImGui::IsMouseClicked(0)) return false;
  dragged_ = hovered_;
  return true;
}

void ClipHandle::draw(const Ui& ui, ViewArea area) const {
  const WindowState& m = ui.window;
  const auto p = has_handle(m) ? places(ui, area.size) : std::nullopt;
  if (!p) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto on_screen = [&](ImVec2 at) { return ImVec2{area.low.x + at.x, area.low.y + at.y}; };
  const auto lit = [&](Part part) { return hovered_ == part || dragged_ == part; };
  list.PushClipRect(area.low, {area.low.x + area.size.x, area.low.y + area.size.y}, true);
  const SectionPlane plane = section_plane(m.view.clip);
  std::vector<ImVec2> outline;
  for (const PlanePoint& corner : cut_box(m.scene_bounds(), plane)) {
    const ScreenPoint s = project(m.camera, plane.lift(corner), static_cast<double>(area.size.x),
                                  static_cast<double>(area.size.y));
    if (s.visible) outline.push_back(on_screen({static_cast<float>(s.x), static_cast<float>(s.y)}));
  }
  const bool hot = hovered_ != Part::none || dragged_ != Part::none;
  if (outline.size() > 2)
    list.AddPolyline(outline.data(), static_cast<int>(outline.size()),
                     to_u32(ui.colors.accent, hot ? 0.9f : 0.45f), ImDrawFlags_Closed,
                     ui.px(hot ? 1.6f : 1.0f));
  const ImVec2 disc = on_screen(p->disc), tip = on_screen(p->tip);
  list.AddLine(disc, tip, to_u32(ui.colors.ground, 0.8f), ui.px(5));
  list.AddLine(disc, tip, to_u32(ui.colors.accent), ui.px(2));
  const auto knob = [&](ImVec2 at, float radius, bool strong) {
    list.AddCircleFilled(at, ui.px(radius + 2), to_u32(ui.colors.ground, 0.8f), 24);
    list.AddCircleFilled(at, ui.px(strong ? radius + 1 : radius),
                         to_u32(strong ? ui.colors.accent_text : ui.colors.accent), 24);
  };
  knob(disc, 7, lit(Part::disc));
  knob(tip, 4.5f, lit(Part::tip));
  list.PopClipRect();
  if (hovered_ != Part::none && !ImGui::IsAnyMouseDown())
    ImGui::SetTooltip("%s", hovered_ == Part::disc ? "Moves the plane" : "Turns the plane");
}

} // namespace isoscope
