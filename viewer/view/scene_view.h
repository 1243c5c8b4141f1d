// The 3D view and the section: draws the renderer's picture, turns the mouse into camera moves and picks.
#pragma once

#include "ask/investigation.h"
#include "edge/target_handle.h"
#include "scene/renderer.h"
#include "view/camera_mouse.h"
#include "view/clip_handle.h"
#include "view/scene_key.h"
#include "view/view_picture.h"
#include "view/zero_maps.h"

#include <memory>
#include <optional>

namespace isoscope {

/// Keeps the last picture and redraws it only when something in it changed.
class SceneView {
 public:
  SceneView(Renderer& renderer, const EdgeProbe& probe, const Investigation& asked, const ZeroMaps& maps)
      : renderer_(&renderer), probe_(probe), asked_(asked), maps_(maps) {}

  /// Fills the present window of the interface.
  void draw(Ui& ui);
  /// Whether another frame is due although nothing asks for one: the picture is not yet at full quality.
  bool unfinished() const { return scene_.unfinished() || section_.unfinished(); }
  /// The last picture of the main view.
  const Renderer::Frame& picture() const { return main().frame(); }
  /// Pixels of that picture on the screen and of a unit of the interface.
  struct Extent {
    int width = 0, height = 0;
    float pixel_scale = 1;
  };
  Extent extent() const { return {main().width(), main().height(), main().pixel_scale()}; }
  /// While nobody has moved the section, what the plane cuts of the input is centred.
  void place_untouched_section(WindowState& window, float aspect);
  /// Moves camera or section to what was asked for.
  void frame_selection(Ui& ui);

 private:
  using Area = ViewArea;
  void draw_scene(Ui& ui, Area area);
  void draw_section(Ui& ui, Area area);
  const ViewPicture& main() const { return scene_shown_ ? scene_ : section_; }
  void render(Ui& ui, Area area, bool section);
  void scene_mouse(Ui& ui, Area area);
  void section_mouse(Ui& ui, Area area);
  void picked(Ui& ui, const Pick& pick);
  void frame_untouched(Ui& ui, float aspect);
  Pick hover_pick(Ui& ui, Area area, bool section);

  Renderer* renderer_;
  const EdgeProbe& probe_;
  const Investigation& asked_;
  const ZeroMaps& maps_;
  ViewPicture scene_, section_;
  bool scene_shown_ = false, section_shown_ = false;
  /// Of the last frame: their addresses tell pictures apart.
  std::shared_ptr<const EdgeXray> xray_;
  std::shared_ptr<const TargetStudy> study_;
  std::shared_ptr<const Annotation> annotation_;
  std::shared_ptr<const ViolationPreview> preview_;
  std::shared_ptr<const ZeroMap> zero_map_;
  KeptLegend legend_;
  TargetHandle handle_;
  CameraMouse mouse_;
  ClipHandle clip_handle_;
  float framed_aspect_ = 0; ///< what the camera was framed for, while nobody has moved it
  Box3 framed_box_;
  CameraPose framed_;
  ClipSettings placed_clip_;
  Renderer::SectionView placed_;
  const void* placed_scene_ = nullptr;
  float placed_aspect_ = 0;
  bool dragged_ = false; ///< the section
  double hover_since_ = 0;
  ImVec2 hover_at_{-1, -1};
  bool hover_asked_ = false;
};

} // namespace isoscope
