// Draws the answers to questions about the state over the finished picture.
#pragma once

#include "scene/annotation.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/view_frame.h"

namespace isoscope {

class AnnotationLayer {
 public:
  /// `annotation` may be null.
  void update(const Annotation* annotation, const ViewFrame& frame);
  /// Strong where visible, fainter where hidden by opaque things.
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  MeshBatch faces_;
  LineBatch lines_;
  MarkerBatch marks_;
};

} // namespace isoscope
