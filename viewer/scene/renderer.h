// Draws a state into a framebuffer of its own and answers picks; knows layers and OpenGL, nothing of panels
// or sessions.
#pragma once

#include "base/status.h"
#include "questions/snapshot.h"
#include "scene/camera.h"
#include "scene/view_settings.h"
#include "tolerance/distance_grid.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

struct Annotation;
struct EdgeXray;
struct TargetStudy;
struct ZeroMap;

/// How much work a frame may cost.
enum class Quality : std::uint8_t { moving, rest };

/// Which part of a larger picture a frame is; the frame may reach beyond the picture.
struct PictureTile {
  int x = 0, y = 0;                    ///< of the frame's top left corner in the picture, pixels
  int full_width = 0, full_height = 0; ///< of the picture
};

/// One frame's request. Sizes in framebuffer pixels.
struct FrameRequest {
  int width = 0, height = 0;
  Quality quality = Quality::rest;
  float pixel_scale = 1; ///< content scale of the monitor: line widths and disc sizes follow it
  Pick selection, hover;
  std::optional<Vec3> mark; ///< a point to be seen: a witness
  float pulse = 0;          ///< in [0, 1): phase for the highlight of the current operation
  bool transparent_background = false;
  /// Number of this frame among those of one resting picture: 0 is a picture by itself; the others, each a
  /// part of a pixel aside, are averaged with what was drawn before them, and come right after it.
  int still = 0;
  /// One of those others may be made by this many calls, so that none takes long: each draws a strip of Ω,
  /// from `strip` 0 on, with nothing else drawn between, and the last one adds the frame to the average.
  int strip = 0, strips = 1;
  /// Draws this part of a larger picture, into targets of its own: the frame of the window stays valid.
  std::optional<PictureTile> tile;
};

/// Owns all GPU resources of the 3D view; needs a current OpenGL 4.1 core context during its whole life.
class Renderer {
 public:
  /// Compiles the shaders; fails with device and the driver's log.
  static Result<std::unique_ptr<Renderer>> create();
  ~Renderer();

  /// What to show; cheap when unchanged. Any may be null.
  void set_scene(std::shared_ptr<const Scene> scene);
  /// What there is before the scene: the input alone, which a scene replaces by its own. After set_scene().
  void set_input(std::shared_ptr<const TriangleSoup> input);
  void set_grid(std::shared_ptr<const DistanceGrid> grid);
  /// A part of Ω in finer voxels; goes with the grid.
  void set_detail(std::shared_ptr<const DistanceGrid> detail);
  void set_state(std::shared_ptr<const StateSnapshot> state);
  /// The state of another run, whose Z is drawn over this one's.
  void set_other(std::shared_ptr<const StateSnapshot> other);
  void set_xray(std::shared_ptr<const EdgeXray> xray);
  void set_study(std::shared_ptr<const TargetStudy> study);
  void set_annotation(std::shared_ptr<const Annotation> annotation);
  /// What would violate in the state under other parameters.
  void set_preview(std::shared_ptr<const ViolationPreview> preview);
  /// What Z is coloured by, of the state shown.
  void set_zero_map(std::shared_ptr<const ZeroMap> map);
  Box3 bounds() const;

  /// Renders the 3D view; returns the colour texture's name, valid until the next call
  /// of its kind (view, section, tile). Resolution may be
  /// lower while moving; the texture is then to be stretched.
  struct Frame {
    std::uint32_t texture = 0;
    int width = 0, height = 0;
  };
  Frame render(const Camera& camera, const ViewSettings& view, const FrameRequest& request);
  /// Renders the 2D section by the clip's plane (through clip.point, normal clip.normal).
  struct SectionView {
    double u = 0, v = 0; ///< centre in the plane's coordinates, scene units, relative to clip.point
    double height = 1;   ///< visible height, scene units
    friend bool operator==(const SectionView&, const SectionView&) = default;
  };
  Frame render_section(const SectionView& section, const ViewSettings& view, const FrameRequest& request);

  /// The nearest element under a framebuffer position (origin top left) that the layers, the filter and the
  /// clip let see. `depth_index`: 0 nearest, 1 the next deeper ...
  Pick pick(const Camera& camera, const ViewSettings& view, double x, double y, int width, int height,
            PickKinds kinds, int depth_index = 0) const;
  Pick pick_section(const SectionView& section, const ViewSettings& view, double x, double y, int width,
                    int height, PickKinds kinds) const;
  /// The visible surface point under a position, for orbiting; the target's depth where nothing is hit.
  Vec3 point_under(const Camera& camera, const ViewSettings& view, double x, double y, int width,
                   int height) const;
  /// Reads back a frame as RGBA with straight alpha, rows top to bottom.
  std::vector<std::uint8_t> read_pixels(const Frame& frame) const;
  /// Seconds the GPU or the software driver needed for the last frame. A frame at rest may take several times
  /// one that moves: ask for rest once the mouse is still and the shown step no longer changes.
  double last_frame_seconds() const;
  /// How many visible samples the last frame left out, because they were too many or would have merged on the
  /// screen; zooming in brings them back.
  std::size_t thinned_samples() const;

 private:
  Renderer();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The plane's axes: u, v and normal right-handed, v as upright as possible.
struct PlaneAxes {
  Vec3 u, v, normal;
};
PlaneAxes plane_axes(Vec3 normal);

} // namespace isoscope
