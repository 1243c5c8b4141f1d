// The target of the X-ray under the mouse: dragged in the plane of the view; candidates that are hovered.
#pragma once

#include "edge/probe.h"
#include "ui/ui.h"

namespace isoscope {

/// What the mouse does to targets in the 3D view.
class TargetHandle {
 public:
  /// Called after the view's own item, before the mouse turns the camera. True while it takes the mouse.
  bool update(Ui& ui, const EdgeProbe& probe, ImVec2 low, ImVec2 size, bool hovered);

 private:
  bool dragging_ = false;
  double depth_ = 1; ///< of the target from the eye, along the view
};

} // namespace isoscope
