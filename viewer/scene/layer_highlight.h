// What the current operation touched, and what is selected: added elements solid, removed ones dashed, moves
// as arrows.
#pragma once

#include "questions/snapshot.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

namespace isoscope {

class HighlightLayer {
 public:
  /// Rebuilds the marks; cheap. `state` may be null.
  void update(const StateSnapshot* state, const ViewFrame& frame);
  /// Draws over the finished picture: strong where visible, faint where hidden by opaque things.
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  LineBatch operation_, selection_;
  MarkerBatch marks_;
};

} // namespace isoscope
