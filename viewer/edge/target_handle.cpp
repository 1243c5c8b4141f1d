// Points are compared on the screen; a drag keeps the target's depth.
#include "edge/target_handle.h"

#include "scene/overlay.h"

#include <cmath>
#include <numbers>

namespace isoscope {
namespace {

constexpr float reach = 11; ///< of a mark, in units of the interface

/// The point that a drag would take: the target tried, else the one found.
std::optional<Vec3> handle_of(const WindowState& m, const EdgeXray& xray) {
  if (m.selection.what_if) return m.selection.what_if;
  return xray.attempt.possible() ? std::optional(xray.attempt.target) : std::nullopt;
}

/// From the mouse; negative where it is out of reach.
double distance_to(const Ui& ui, Vec3 p, ImVec2 mouse, ImVec2 size) {
  const ScreenPoint s =
      project(ui.window.camera, p, static_cast<double>(size.x), static_cast<double>(size.y));
  const double d = std::hypot(s.x - static_cast<double>(mouse.x), s.y - static_cast<double>(mouse.y));
  return s.visible && d <= static_cast<double>(ui.px(reach)) ? d : -1;
}

} // namespace

bool TargetHandle::update(Ui& ui, const EdgeProbe& probe, ImVec2 low, ImVec2 size, bool hovered) {
  WindowState& m = ui.window;
  const auto xray = probe.xray();
  if (!xray || !m.view.xray.shown()) {
    dragging_ = dragging_ && ImGui::IsMouseDown(0) && m.selection.what_if;
    if (!dragging_) return false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse{io.MousePos.x - low.x, io.MousePos.y - low.y};
  if (dragging_) {
    if (!ImGui::IsMouseDown(0)) {
      dragging_ = false;
      return true; // the release picks nothing
    }
    if (m.selection.what_if && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
      const CameraPose& pose = m.camera.pose();
      const double depth = pose.orthographic ? pose.distance : depth_;
      const double unit =
          2 * depth * std::tan(pose.fov * std::numbers::pi / 360) / static_cast<double>(size.y);
      const Vec3 along{static_cast<double>(io.MouseDelta.x) * unit,
                       -static_cast<double>(io.MouseDelta.y) * unit, 0};
      m.selection.try_target(*m.selection.what_if + m.camera.to_world(along));
    }
    return true;
  }
  if (!hovered) {
    m.selection.hovered_candidate.reset();
    return false;
  }
  const auto handle = handle_of(m, *xray);
  const bool over = handle && distance_to(ui, *handle, mouse, size) >= 0;
  if (over) {
    m.selection.hovered_candidate.reset();
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    if (!ImGui::IsMouseClicked(0)) return false;
    dragging_ = true;
    m.selection.try_target(*handle);
    depth_ = std::abs(dot(*handle - m.camera.eye(), m.camera.to_world({0, 0, -1})));
    return true;
  }
  if (ImGui::IsAnyMouseDown() && !ImGui::IsMouseClicked(0)) return false;
  std::optional<std::uint32_t> nearest;
  double least = 0;
  for (std::uint32_t i = 0; i < xray->attempt.candidates.size(); ++i) {
    const double d = distance_to(ui, xray->attempt.candidates[i].point, mouse, size);
    if (d >= 0 && (!nearest || d < least)) nearest = i, least = d;
  }
  if (nearest && ImGui::IsMouseClicked(0)) {
    dragging_ = true;
    const Vec3 point = xray->attempt.candidates[*nearest].point;
    m.selection.try_target(point, nearest);
    depth_ = std::abs(dot(point - m.camera.eye(), m.camera.to_world({0, 0, -1})));
    return true;
  }
  m.selection.hovered_candidate = nearest;
  return false;
}

} // namespace isoscope
