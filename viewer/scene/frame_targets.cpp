// The pictures a frame is made of: opaque, translucent sums, Ω, and the result.
#include "scene/frame_targets.h"

#include <glad/gl.h>

#include <algorithm>

namespace isoscope {

Status FrameTargets::resize(int new_width, int new_height, int new_samples, int new_volume_width,
                            int new_volume_height) {
  using gl::Format;
  if (new_width != width || new_height != height) {
    color.allocate(new_width, new_height, Format::rgba8);
    depth.allocate(new_width, new_height, Format::depth);
    cell_sum.allocate(new_width, new_height, Format::rgba16f);
    cell_cover.allocate(new_width, new_height, Format::r16f);
    result.allocate(new_width, new_height, Format::rgba8, 1, true);
    for (Status s : {opaque.attach({&color}, &depth), cells.attach({&cell_sum, &cell_cover}, &depth),
                     output.attach({&result}, &depth)})
      if (!s) return s;
  }
  if (new_samples > 1 && (new_width != width || new_height != height || new_samples != samples)) {
    samples_color.allocate(new_width, new_height, Format::rgba8, new_samples);
    samples_depth.allocate(new_width, new_height, Format::depth, new_samples);
    if (Status s = multisampled.attach({&samples_color}, &samples_depth); !s) return s;
  }
  if (new_volume_width != volume_width || new_volume_height != volume_height) {
    volume_color.allocate(new_volume_width, new_volume_height, Format::rgba16f, 1, true);
    volume_depth.allocate(new_volume_width, new_volume_height, Format::r16f);
    if (Status s = volume.attach({&volume_color, &volume_depth}, nullptr); !s) return s;
  }
  // A single-sampled size change leaves the multisampled pictures behind: they are made anew when next asked
  // for.
  const bool stale = new_samples <= 1 && (new_width != width || new_height != height);
  width = new_width;
  height = new_height;
  samples = new_samples > 1 ? new_samples : (stale ? 0 : samples);
  volume_width = new_volume_width;
  volume_height = new_volume_height;
  return {};
}

Status FrameTargets::prepare_average() {
  if (average.id() != 0 && average.width() == width && average.height() == height) return {};
  average.allocate(width, height, gl::Format::rgba32f, 1, true);
  return averaging.attach({&average}, nullptr);
}

std::vector<std::uint8_t> read_picture(std::uint32_t texture, int columns, int rows) {
  if (texture == 0) return {};
  const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
  std::vector<std::uint8_t> upward(4 * width * height), pixels(upward.size());
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  for (std::size_t row = 0; row < height; ++row)
    std::copy_n(upward.begin() + static_cast<std::ptrdiff_t>(4 * width * (height - 1 - row)), 4 * width,
                pixels.begin() + static_cast<std::ptrdiff_t>(4 * width * row));
  // Frames are premultiplied, picture files are not.
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const unsigned alpha = pixels[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t k = 0; k < 3; ++k)
      pixels[i + k] = static_cast<std::uint8_t>(std::min(255u, (pixels[i + k] * 255u + alpha / 2) / alpha));
  }
  return pixels;
}

} // namespace isoscope
