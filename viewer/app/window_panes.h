// The panes of the window: what stands where, and the strips between them.
#pragma once

#include "app/app_model.h"
#include "app/overlays.h"
#include "mosaic/mosaic_view.h"
#include "timeline/timeline_panel.h"
#include "two_runs/run_views.h"

namespace isoscope {

class WindowPanes {
 public:
  /// All must outlive the panes.
  WindowPanes(AppModel& model, RunViews& views, MosaicView& mosaic, TimelinePane& timeline,
              Overlays& overlays)
      : model_(model), views_(views), mosaic_(mosaic), timeline_(timeline), overlays_(overlays) {}
  /// Everything in the window, for one frame. `resting`: the mouse has not moved for a while, and its pointer
  /// is hidden where somebody presents.
  void draw(Ui& ui, bool resting);

 private:
  /// The window in presenter mode.
  void present(Ui& ui, ImVec2 size, bool resting);
  /// The window with a folder of tiles, `low` to `high`: between the bars.
  void tiles(Ui& ui, float low, float high, float width);
  void status_bar(Ui& ui, ImVec2 size, float high);
  /// What lies over all panes: messages, from there on in so much room, and overlays.
  void finish(Ui& ui, ImVec2 size, ImVec2 messages, float room);

  AppModel& model_;
  RunViews& views_;
  MosaicView& mosaic_;
  TimelinePane& timeline_;
  Overlays& overlays_;
};

} // namespace isoscope
