// The middle of the window: one run, or two beside each other, each with its letter and what tells it apart.
#pragma once

#include "two_runs/comparison.h"
#include "view/camera_mouse.h"
#include "view/scene_view.h"
#include "view/view_picture.h"

#include <memory>
#include <optional>

namespace isoscope {

/// The view of the run that is not active: the same camera, clip and layers on another state.
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

class RunViews {
 public:
  RunViews(SceneView& active, Comparison& comparison) : active_(&active), comparison_(comparison) {}
  /// Fills the present window of the interface.
  void draw(Ui& ui);
  bool unfinished() const { return active_->unfinished() || other_.unfinished(); }

 private:
  void make_room(Ui& ui);
  SceneView* active_;
  Comparison& comparison_;
  OtherView other_;
  /// Which panes were open before two views needed their room.
  std::optional<PaneLayout> before_;
};

/// The letter of a run in a square, filled where it is the active one; returns its width.
float run_badge(const Ui& ui, ImVec2 at, bool b, bool active);

} // namespace isoscope
