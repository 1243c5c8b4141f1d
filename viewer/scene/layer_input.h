// The input triangles.
#pragma once

#include "input/triangle_soup.h"
#include "scene/clip.h"
#include "scene/mesh_batch.h"
#include "scene/view_frame.h"

namespace isoscope {

class InputLayer {
 public:
  void update(const TriangleSoup& soup, const Clip& clip, const SceneColors& colors, const SceneSpace& space);
  void clear() { batch_.upload(MeshBuilder()); }
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  MeshBatch batch_;
};

} // namespace isoscope
