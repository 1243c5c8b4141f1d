// Tetrahedra as shrunk copies: violating ones solid in their condition's colour, the others faint.
#pragma once

#include "scene/mesh_batch.h"
#include "scene/tet_visibility.h"
#include "scene/view_frame.h"

namespace isoscope {

class TetrahedraLayer {
 public:
  /// `side_tint`: plain and changed ones in the colour of their side once Z is embedded.
  void update(const StateSnapshot& state, const TetFilter& filter, bool side_tint, const Clip& clip,
              const SceneColors& colors, const SceneSpace& space);
  void clear();
  void draw_solid(gl::Program& program, const ViewFrame& frame);
  void draw_faint(gl::Program& program, const ViewFrame& frame);
  bool has_faint() const { return !faint_.empty(); }
  bool has_solid() const { return !solid_.empty(); }

 private:
  MeshBatch solid_, faint_;
};

/// The colour of a role.
glm::vec3 role_color(TetRole role, const SceneColors& colors);

} // namespace isoscope
