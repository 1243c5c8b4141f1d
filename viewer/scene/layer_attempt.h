// The edge under the X-ray: its kernel, the candidates by reason, link offenders, optimum and target.
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
  /// Rebuilds everything; `xray` may be null. `mark`: a point to be seen, a witness.
  void update(const EdgeXray* xray, const std::optional<Vec3>& mark, const SceneColors& colors,
              const SceneSpace& space);
  /// Translucent faces, lines and marks over the finished picture, fainter where Z hides them.
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  MeshBatch kernel_;
  LineBatch edges_;
  MarkerBatch marks_;
};

} // namespace isoscope
