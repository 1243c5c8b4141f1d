// The edge under the X-ray: its kernel, what the search left out, the candidates by reason, link offenders,
// optimum and target; the ghost of a target that is tried.
#pragma once

#include "questions/target_study.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

namespace isoscope {

class AttemptLayer {
 public:
  /// Rebuilds everything; both may be null, and a study is shown with its X-ray alone.
  void update(const EdgeXray* xray, const TargetStudy* study, const ViewFrame& frame);
  /// Translucent faces, lines and marks over the finished picture, fainter where Z hides them.
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  MeshBatch kernel_;
  LineBatch edges_;
  MarkerBatch marks_;
};

} // namespace isoscope
