// The edge under the X-ray: its kernel, what the search left out, the candidates by reason, link offenders,
// optimum and target.
#pragma once

#include "run/edge_xray.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

namespace isoscope {

class AttemptLayer {
 public:
  /// Rebuilds everything; `xray` may be null.
  void update(const EdgeXray* xray, const ViewFrame& frame);
  /// Translucent faces, lines and marks over the finished picture, fainter where Z hides them.
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  MeshBatch kernel_;
  LineBatch edges_;
  MarkerBatch marks_;
};

} // namespace isoscope
