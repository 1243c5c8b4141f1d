// The layers of the 3D view: keeps their buffers up to date and draws them in their passes.
#pragma once

#include "scene/layer_cut.h"
#include "scene/layer_points.h"
#include "scene/layer_preview.h"
#include "scene/layer_samples.h"
#include "scene/layer_tolerance.h"
#include "scene/layers.h"
#include "scene/quality_control.h"

#include <memory>

namespace isoscope {

/// What there is to be drawn; any may be null.
struct LayerInputs {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const TriangleSoup> input; ///< the scene's, or what is known before it
  std::shared_ptr<const InputPoints> points;
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const StateSnapshot> other; ///< of the run beside this one: its Z
  std::shared_ptr<const EdgeXray> xray;
  std::shared_ptr<const TargetStudy> study;
  std::shared_ptr<const Annotation> annotation;
  std::shared_ptr<const ViolationPreview> preview; ///< of the state
  std::shared_ptr<const ZeroMap> zero_map;         ///< of the state

  /// The rim of an open input, null where there is none.
  const Rim* rim() const;
};

class SceneLayers {
 public:
  ToleranceLayer tolerance;

  /// Buffers made from another scene, state or origin are made anew.
  void forget_scene();
  void forget_state();
  void forget_other() { other_zero_.built = {}; }
  void forget_all();
  /// Rebuilds what is shown and stale.
  void update(const LayerInputs& inputs, const ViewFrame& frame);
  void draw_opaque(Programs& programs, const ViewFrame& frame, const FrameQuality& quality);
  /// Whether there is something for draw_cells().
  bool has_cells(const ViewSettings& view) const;
  /// What is translucent, in any order.
  void draw_cells(Programs& programs, const ViewFrame& frame);
  /// What lies over the finished picture.
  void draw_over(Programs& programs, const ViewFrame& frame);
  std::size_t thinned_samples() const { return samples_.layer.thinned(); }

 private:
  /// What the buffers of a layer were built from; another value asks for a rebuild.
  struct Built {
    bool made = false;
    const void* source = nullptr;
    std::shared_ptr<const ZeroMap> map{};
    ClipSettings clip;
    ThemeKind theme = ThemeKind::dark;
    TetFilter tets;
    bool good = true, bad = true, over_rim = true, near_samples = true;
    Moment moment = Moment::both;
    friend bool operator==(const Built&, const Built&) = default;
  };
  template <class Layer> struct Kept {
    Layer layer;
    Built built;
  };
  Kept<OtherZeroLayer> other_zero_;
  Kept<InputLayer> input_;
  Kept<RimLayer> rim_;
  Kept<ZeroSetLayer> zero_set_;
  Kept<CurvesLayer> curves_;
  Kept<DroppedLayer> dropped_;
  Kept<GammaLayer> gamma_;
  Kept<TetrahedraLayer> tetrahedra_;
  Kept<PointsLayer> points_;
  Kept<SamplesLayer> samples_;
  CutLayer cut_;
  HighlightLayer highlight_;
  AttemptLayer attempt_;
  AnnotationLayer annotations_;
  PreviewLayer preview_;
};

} // namespace isoscope
