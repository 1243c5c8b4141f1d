// The layers of the scene that batches of triangles, lines and marks make, in the order in which they are
// drawn.
#pragma once

#include "input/triangle_soup.h"
#include "questions/snapshot.h"
#include "questions/target_study.h"
#include "questions/zero_map.h"
#include "scene/annotation.h"
#include "scene/clip.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/tet_visibility.h"
#include "scene/view_frame.h"
#include "tolerance/rim.h"

#include <optional>
#include <vector>

namespace isoscope {

/// The input triangles.
class InputLayer {
 public:
  void update(const TriangleSoup& soup, const Clip& clip, const SceneColors& colors, const SceneSpace& space);
  void clear() { batch_.upload(MeshBuilder()); }
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  MeshBatch batch_;
};

/// Z: shaded polygons with their edges. Where it parts rooms each side shows what lies behind it, hatched in
/// the colour of the room before it.
class ZeroSetLayer {
 public:
  /// `before`: as it was before the current operation, where Z is embedded or free.
  /// With a map of the state it is coloured by its values; null: in its own colour.
  void update(const StateSnapshot& state, Moment moment, const ZeroMap* map, const Clip& clip,
              const SceneColors& colors, const SceneSpace& space);
  void clear() { sheets_.clear(); }
  /// Opaque pass, or translucent when the layer's opacity is below 1.
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  /// The polygons between two labels; without walls where there is one inside.
  struct Sheet {
    std::optional<WallStyle> walls;
    MeshBatch batch;
  };
  std::vector<Sheet> sheets_;
};

/// What the sides of a sheet of Z between two labels show.
WallStyle wall_style(LabelPair labels);

/// The border of Z, the curves where three sheets or more meet, and the points where these end, branch or
/// cross.
class CurvesLayer {
 public:
  void update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
              const SceneSpace& space);
  void clear();
  void draw(Programs& programs, const ViewFrame& frame);

 private:
  LineBatch lines_;
  MarkerBatch points_;
};

/// The border of an open input: solid where Ω leaves it open, dashed where it is bridged.
class RimLayer {
 public:
  void update(const Rim& rim, const Clip& clip, const SceneColors& colors, const SceneSpace& space);
  void clear() { lines_.upload(LineBuilder()); }
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  LineBatch lines_;
};

/// What was cut off Z along the rim.
class DroppedLayer {
 public:
  void update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
              const SceneSpace& space);
  void clear() { batch_.upload(MeshBuilder()); }
  /// Opaque pass, or translucent when the layer's opacity is below 1.
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  MeshBatch batch_;
};

/// The edges of ∂Γ.
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

/// Z of the run beside this one, as lines.
class OtherZeroLayer {
 public:
  void update(const StateSnapshot& state, const Clip& clip, const SceneColors& colors,
              const SceneSpace& space);
  void clear() { batch_.upload(LineBuilder()); }
  void draw(gl::Program& program, const ViewFrame& frame);

 private:
  LineBatch batch_;
};

/// Tetrahedra as shrunk copies: violating ones solid in their condition's colour, the others faint.
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

/// What the current operation touched, and what is selected: added elements solid, removed ones dashed, moves
/// as arrows.
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

/// The edge under the X-ray: its kernel, what the search left out, the candidates by reason, link offenders,
/// optimum and target; the ghost of a target that is tried.
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

/// Draws the answers to questions about the state over the finished picture.
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
