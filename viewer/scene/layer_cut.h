// What lies on the face of a cut by a plane: Z's line and the samples, over Ω's band.
#pragma once

#include "questions/snapshot.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

#include <memory>

namespace isoscope {

class CutLayer {
 public:
  /// Whether a view has such a face, seen from where it lies open.
  static bool shown(const ViewFrame& frame);
  /// Made anew where something that it depends on has changed; `aside`: how far what is drawn lies on the
  /// side that is kept, where it is not cut away itself.
  void update(const std::shared_ptr<const StateSnapshot>& state, double aside, const ViewFrame& frame);
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  struct Made {
    const StateSnapshot* state = nullptr;
    ViewSettings view;
    SceneSpace space;
    friend bool operator==(const Made&, const Made&) = default;
  };
  Made made_;
  LineBatch lines_;
  MarkerBatch samples_;
};

} // namespace isoscope
