// A picture of any size, drawn in tiles.
#include "export/tiled_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace isoscope {
namespace {

constexpr int tile_side = 1024;
/// The window is drawn between two calls.
constexpr auto longest_call = std::chrono::milliseconds(80);
/// Discs, lines and Ω's coarser picture reach over a tile's rim, by units of the interface.
constexpr double rim_units = 24;

} // namespace

TiledPicture::TiledPicture(Shot shot) : shot_(std::move(shot)) {
  columns_ = (shot_.width + tile_side - 1) / tile_side;
  rows_ = (shot_.height + tile_side - 1) / tile_side;
  image_ = {shot_.width, shot_.height, {}};
  image_.pixels.resize(4 * static_cast<std::size_t>(shot_.width) * static_cast<std::size_t>(shot_.height));
}

Result<bool> TiledPicture::advance(Renderer& renderer) {
  const int rim = std::min(static_cast<int>(std::ceil(rim_units * static_cast<double>(shot_.pixel_scale))),
                           tile_side / 2);
  const int x = next_ % columns_ * tile_side, y = next_ / columns_ * tile_side;
  const int width = std::min(tile_side, shot_.width - x), height = std::min(tile_side, shot_.height - y);
  FrameRequest request;
  request.width = width + 2 * rim;
  request.height = height + 2 * rim;
  request.pixel_scale = shot_.pixel_scale;
  request.selection = shot_.selection;
  request.mark = shot_.mark;
  request.transparent_background = shot_.alpha;
  request.tile = PictureTile{x - rim, y - rim, shot_.width, shot_.height};
  Renderer::Frame frame;
  const auto begun = std::chrono::steady_clock::now();
  do {
    request.still = still_++;
    frame = shot_.view.mode == ViewMode::section ? renderer.render_section(shot_.section, shot_.view, request)
                                                 : renderer.render(shot_.camera, shot_.view, request);
    if (frame.texture == 0)
      return Error{ErrorCode::device, "The graphics driver has no room for a part of the picture.",
                   "Close other programs that use the graphics card."};
  } while (still_ < shot_.stills && std::chrono::steady_clock::now() - begun < longest_call);
  if (still_ < shot_.stills) return false;
  still_ = 0;
  const std::vector<std::uint8_t> pixels = renderer.read_pixels(frame);
  for (int row = 0; row < height; ++row) {
    const auto from = 4 * (static_cast<std::ptrdiff_t>(row + rim) * frame.width + rim);
    const auto to = 4 * (static_cast<std::ptrdiff_t>(y + row) * shot_.width + x);
    std::copy_n(pixels.begin() + from, 4 * static_cast<std::ptrdiff_t>(width), image_.pixels.begin() + to);
  }
  return ++next_ == columns_ * rows_;
}

} // namespace isoscope
