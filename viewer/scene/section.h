// Draws the 2D section as the paper's figures do: T thin, Z thick, ∂Γ blue, samples by class, the Steiner
// point ringed; points of the input by weight; kernel, Ψ, octree and candidates of the edge at hand.
#pragma once

#include "scene/input_points.h"
#include "scene/layer_tolerance.h"
#include "scene/line_batch.h"
#include "scene/markers.h"
#include "scene/mesh_batch.h"
#include "scene/programs.h"
#include "scene/scene_layers.h"
#include "scene/section_geometry.h"
#include "scene/section_view.h"
#include "scene/view_frame.h"

#include <vector>

namespace isoscope {

class SectionLayer {
 public:
  /// Intersects and uploads.
  void update(const LayerInputs& inputs, const ViewFrame& frame);
  void draw(Programs& programs, const ViewFrame& frame, ToleranceLayer& tolerance, float background_opacity);

 private:
  /// The cells of one side, hatched where it is a room.
  struct Side {
    WallStyle style;
    MeshBatch cells;
  };
  std::vector<Side> sides_;
  MeshBatch attempt_; ///< areas of the edge at hand
  LineBatch lines_, marked_;
  MarkerBatch points_, samples_, marks_;
};

} // namespace isoscope
