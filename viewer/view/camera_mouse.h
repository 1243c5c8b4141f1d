// Turns drags, the wheel and double clicks over a view into moves of its camera.
#pragma once

#include "view/view_picture.h"

#include <functional>

namespace isoscope {

constexpr ImGuiButtonFlags every_button =
    ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;

class CameraMouse {
 public:
  /// For the last item, which fills the area. `under`: the point of the scene under the mouse.
  void update(const Ui& ui, Camera& camera, ViewArea area, const std::function<Vec3()>& under);
  /// Since the button went down it was a drag, not a click.
  bool dragged() const { return dragged_; }
  /// Something else takes this drag.
  void take() { dragged_ = true; }

 private:
  Vec3 pivot_;
  bool dragged_ = false;
};

} // namespace isoscope
