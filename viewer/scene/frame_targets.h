// The pictures a frame is made of: opaque, translucent sums, Ω, and the result.
#pragma once

#include "base/status.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"

#include <cstdint>
#include <vector>

namespace isoscope {

/// Textures and framebuffers of one size; resizing to the present size costs nothing.
struct FrameTargets {
  gl::Texture samples_color, samples_depth; ///< multisampled opaque picture
  gl::Texture color, depth;                 ///< opaque picture, resolved
  gl::Texture cell_sum, cell_cover;       ///< weighted sum and product of transparencies of translucent cells
  gl::Texture volume_color, volume_depth; ///< Ω, premultiplied
  gl::Texture result;
  gl::Texture average; ///< of frames of a resting picture
  gl::Framebuffer multisampled, opaque, cells, volume, output, averaging;
  int width = 0, height = 0, samples = 0, volume_width = 0, volume_height = 0;

  /// Makes room for the average of frames of the present size.
  Status prepare_average();
  Status resize(int new_width, int new_height, int new_samples, int new_volume_width, int new_volume_height);
};

/// Reads a texture back as RGBA with straight alpha, rows top to bottom; empty for texture 0.
std::vector<std::uint8_t> read_picture(std::uint32_t texture, int width, int height);

} // namespace isoscope
