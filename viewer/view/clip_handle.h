// The clip's plane under the mouse: a disc that moves it along its normal, an arrow whose tip turns it.
#pragma once

#include "ui/ui.h"
#include "view/camera_mouse.h"

namespace isoscope {

/// What the mouse does to the plane in the 3D view.
class ClipHandle {
 public:
  /// Called after the view's own item, before the mouse turns the camera. True while it takes the mouse.
  bool update(Ui& ui, ViewArea area, bool hovered);
  /// Over the picture: where the plane cuts the model's box, and the handle.
  void draw(const Ui& ui, ViewArea area) const;

 private:
  enum class Part : std::uint8_t { none, disc, tip };
  Part hovered_ = Part::none, dragged_ = Part::none;
};

} // namespace isoscope
