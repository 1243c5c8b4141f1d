// The view of the run that is not active: the same camera, clip and layers on another state.
#pragma once

#include "two_runs/comparison.h"
#include "view/camera_mouse.h"
#include "view/view_picture.h"

#include <memory>

namespace isoscope {

/// Has a renderer of its own, so that neither run's geometry is uploaded again while both are drawn.
class OtherView {
 public:
  /// Fills the present window of the interface.
  void draw(Ui& ui, Comparison& comparison);
  bool unfinished() const { return picture_.unfinished(); }
  /// Gives the renderer's memory back.
  void release();

 private:
  bool prepare(Ui& ui);
  std::unique_ptr<Renderer> renderer_;
  ViewPicture picture_;
  CameraMouse mouse_;
};

} // namespace isoscope
