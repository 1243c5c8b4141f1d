// The edges of ∂Γ.
#pragma once

#include "questions/snapshot.h"
#include "scene/clip.h"
#include "scene/line_batch.h"
#include "scene/view_frame.h"

namespace isoscope {

class GammaLayer {
 public:
  /// `box`: also edges that end at a corner of the bounding box.
  void update(const StateSnapshot& state, bool box, const Clip& clip, const SceneColors& colors,
              const SceneSpace& space);
  void clear() { batch_.upload(LineBuilder()); }
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  LineBatch batch_;
};

} // namespace isoscope
