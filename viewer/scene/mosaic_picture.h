// Draws a mosaic of bricks into a framebuffer of its own.
#pragma once

#include "base/status.h"
#include "scene/mosaic_scene.h"
#include "scene/renderer.h"

#include <memory>
#include <optional>

namespace isoscope {

/// Needs a current OpenGL 4.1 core context during its whole life.
class MosaicPicture {
 public:
  /// Compiles the shaders it needs; fails with device and the driver's log.
  static Result<std::unique_ptr<MosaicPicture>> create();
  ~MosaicPicture();

  /// What to show; cheap when unchanged. May be null.
  void set(std::shared_ptr<const MosaicScene> scene, ThemeKind theme);
  /// `lit`: a tile whose box is marked. The frame is valid until the next call.
  Renderer::Frame render(const Camera& camera, std::optional<std::uint32_t> lit, const FrameRequest& request);

 private:
  MosaicPicture();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
