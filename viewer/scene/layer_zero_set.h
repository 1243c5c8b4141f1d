// Z: shaded polygons with their edges.
#pragma once

#include "questions/snapshot.h"
#include "scene/clip.h"
#include "scene/mesh_batch.h"
#include "scene/view_frame.h"

namespace isoscope {

class ZeroSetLayer {
 public:
  /// `before`: as it was before the current operation, where Z is embedded or free.
  void update(const StateSnapshot& state, Moment moment, const Clip& clip, const SceneColors& colors,
              const SceneSpace& space);
  void clear() { batch_.upload(MeshBuilder()); }
  /// Opaque pass, or translucent when the layer's opacity is below 1.
  void draw(gl::Program& program, const ViewFrame& frame);
  bool empty() const { return batch_.empty(); }

 private:
  MeshBatch batch_;
};

} // namespace isoscope
