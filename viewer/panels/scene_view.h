// The 3D view and the section: draws the renderer's picture, turns the mouse into camera moves and picks.
#pragma once

#include "panels/target_handle.h"
#include "panels/ui.h"
#include "scene/annotation.h"
#include "scene/renderer.h"

#include <memory>
#include <optional>

namespace isoscope {

/// Keeps the last picture and redraws it only when something in it changed.
class SceneView {
 public:
  explicit SceneView(Renderer& renderer) : renderer_(&renderer) {}

  /// Fills the present window of the interface.
  void draw(Ui& ui);
  /// Whether another frame is due although nothing asks for one: the picture is not yet at full quality.
  bool unfinished() const { return scene_.unfinished || section_.unfinished; }
  /// The last picture of the main view.
  const Renderer::Frame& picture() const { return scene_.shown ? scene_.frame : section_.frame; }
  /// Pixels of that picture on the screen and of a unit of the interface.
  struct Extent {
    int width = 0, height = 0;
    float pixel_scale = 1;
  };
  Extent extent() const {
    const Key& key = scene_.shown ? scene_.key : section_.key;
    return {key.width, key.pixel_height, pixel_scale_};
  }
  /// While nobody has moved the section, what the plane cuts of the input is centred.
  void place_untouched_section(AppModel& model, float aspect);
  /// Moves camera or section to what was asked for.
  void frame_requests(Ui& ui);

 private:
  /// Everything a picture depends on.
  struct Key {
    CameraPose pose;
    ViewSettings view;
    double u = 0, v = 0, height = 0;
    const void *state = nullptr, *grid = nullptr, *scene = nullptr;
    int width = 0, pixel_height = 0;
    const void *xray = nullptr, *study = nullptr, *annotation = nullptr;
    Pick selection, hover;
    std::optional<Vec3> mark;
    float scale = 1;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Picture {
    Key key;
    Renderer::Frame frame;
    double changed_at = -1;
    bool unfinished = false, shown = false;
  };
  struct Area {
    ImVec2 low, size;
  };
  void draw_scene(Ui& ui, Area area);
  void draw_section(Ui& ui, Area area);
  void render(Ui& ui, Picture& picture, Area area, bool section);
  void scene_mouse(Ui& ui, Area area);
  void section_mouse(Ui& ui, Area area);
  void picked(Ui& ui, const Pick& pick);
  void frame_untouched(Ui& ui, float aspect);
  Pick hover_pick(Ui& ui, Area area, bool section);

  Renderer* renderer_;
  Picture scene_, section_;
  /// Of the last frame: their addresses tell pictures apart.
  std::shared_ptr<const EdgeXray> xray_;
  std::shared_ptr<const TargetStudy> study_;
  std::shared_ptr<const Annotation> annotation_;
  TargetHandle handle_;
  Vec3 pivot_;
  float framed_aspect_ = 0; ///< what the camera was framed for, while nobody has moved it
  Box3 framed_box_;
  ClipSettings placed_clip_;
  const void* placed_scene_ = nullptr;
  float placed_aspect_ = 0;
  float pixel_scale_ = 1;
  bool dragged_ = false;
  double hover_since_ = 0;
  ImVec2 hover_at_{-1, -1};
  bool hover_asked_ = false;
};

} // namespace isoscope
