// Left drag orbits about the point under the mouse, other buttons and Shift pan, the wheel zooms to it.
#include "view/camera_mouse.h"

#include <cmath>

namespace isoscope {

void CameraMouse::update(const Ui& ui, Camera& camera, ViewArea area, const std::function<Vec3()>& under) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated()) {
    pivot_ = under();
    dragged_ = false;
  }
  if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    const float threshold = ui.px(4);
    const int button = ImGui::IsMouseDown(0) ? 0 : ImGui::IsMouseDown(1) ? 1 : 2;
    const ImVec2 total = ImGui::GetMouseDragDelta(button, 0);
    dragged_ = dragged_ || std::hypot(total.x, total.y) > threshold;
    if (dragged_) {
      camera.mark_set();
      if (button != 0 || io.KeyShift)
        camera.pan(io.MouseDelta.x, io.MouseDelta.y, area.size.y, pivot_);
      else
        camera.orbit(io.MouseDelta.x, io.MouseDelta.y, area.size.y, pivot_);
    }
  }
  if (hovered && io.MouseWheel != 0) {
    camera.mark_set();
    camera.zoom(io.MouseWheel, under());
  }
  if (hovered && ImGui::IsMouseDoubleClicked(0)) {
    CameraPose pose = camera.pose();
    const Vec3 point = under();
    pose.distance = distance(camera.eye(), point);
    pose.target = point;
    camera.set(pose, !ui.window.scripted);
    camera.mark_set();
    dragged_ = true;
  }
}

} // namespace isoscope
