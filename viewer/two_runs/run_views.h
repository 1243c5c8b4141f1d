// The middle of the window: one run, or two beside each other, each with its letter and what tells it apart.
#pragma once

#include "two_runs/other_view.h"
#include "view/scene_view.h"

#include <optional>

namespace isoscope {

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
