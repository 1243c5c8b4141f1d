// The list of the window, and pixels with smooth edges.
#include "ui/canvas.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace isoscope {

float Canvas::text_width(std::string_view words) const {
  return font_.CalcTextSizeA(font_.FontSize, 1e9f, 0, words.data(), words.data() + words.size()).x;
}

void WindowCanvas::rect(ImVec2 low, ImVec2 high, Rgb color, float alpha) {
  list_.AddRectFilled(low, high, to_u32(color, alpha));
}
void WindowCanvas::line(ImVec2 a, ImVec2 b, Rgb color, float width) {
  list_.AddLine(a, b, to_u32(color), width);
}
void WindowCanvas::disc(ImVec2 middle, float radius, Rgb color) {
  list_.AddCircleFilled(middle, radius, to_u32(color), 24);
}
void WindowCanvas::ring(ImVec2 middle, float radius, Rgb color, float width) {
  list_.AddCircle(middle, radius, to_u32(color), 24, width);
}
void WindowCanvas::text(ImVec2 at, std::string_view words, Rgb color) {
  list_.AddText(&font_, font_.FontSize, at, to_u32(color), words.data(), words.data() + words.size());
}

ImageCanvas::ImageCanvas(Image& image, ImFontAtlas& atlas, const ImFont& font) : Canvas(font), image_(image) {
  unsigned char* pixels = nullptr;
  atlas.GetTexDataAsAlpha8(&pixels, &atlas_width_, &atlas_height_);
  pixels_ = pixels;
}

void ImageCanvas::blend(int x, int y, Rgb color, float alpha) {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || !(alpha > 0)) return;
  std::uint8_t* const p =
      image_.pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                  static_cast<std::size_t>(x));
  // Straight alpha, over what is there.
  const float below = static_cast<float>(p[3]) / 255, sum = alpha + below * (1 - alpha);
  for (int k = 0; k < 3; ++k) {
    const auto own = static_cast<float>((color >> (16 - 8 * k)) & 0xFF);
    const float mixed = (alpha * own + below * (1 - alpha) * static_cast<float>(p[k])) / sum;
    p[k] = static_cast<std::uint8_t>(std::clamp(std::lround(mixed), 0l, 255l));
  }
  p[3] = static_cast<std::uint8_t>(std::clamp(std::lround(255 * sum), 0l, 255l));
}

template <class Distance>
void ImageCanvas::shape(ImVec2 low, ImVec2 high, Rgb color, float alpha, const Distance& distance) {
  const int x0 = std::max(static_cast<int>(std::floor(low.x)) - 1, 0),
            y0 = std::max(static_cast<int>(std::floor(low.y)) - 1, 0);
  const int x1 = std::min(static_cast<int>(std::ceil(high.x)) + 1, image_.width),
            y1 = std::min(static_cast<int>(std::ceil(high.y)) + 1, image_.height);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const float d = distance(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      blend(x, y, color, alpha * std::clamp(0.5f - d, 0.0f, 1.0f));
    }
}

void ImageCanvas::rect(ImVec2 low, ImVec2 high, Rgb color, float alpha) {
  shape(low, high, color, alpha, [&](float x, float y) {
    return std::max(std::max(low.x - x, x - high.x), std::max(low.y - y, y - high.y));
  });
}

void ImageCanvas::line(ImVec2 a, ImVec2 b, Rgb color, float width) {
  const float dx = b.x - a.x, dy = b.y - a.y, square = std::max(dx * dx + dy * dy, 1e-6f), half = width / 2;
  shape({std::min(a.x, b.x) - half, std::min(a.y, b.y) - half},
        {std::max(a.x, b.x) + half, std::max(a.y, b.y) + half}, color, 1, [&](float x, float y) {
          const float t = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0f, 1.0f);
          return std::hypot(x - a.x - t * dx, y - a.y - t * dy) - half;
        });
}

void ImageCanvas::disc(ImVec2 middle, float radius, Rgb color) {
  shape({middle.x - radius, middle.y - radius}, {middle.x + radius, middle.y + radius}, color, 1,
        [&](float x, float y) { return std::hypot(x - middle.x, y - middle.y) - radius; });
}

void ImageCanvas::ring(ImVec2 middle, float radius, Rgb color, float width) {
  const float reach = radius + width;
  shape({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}, color, 1,
        [&](float x, float y) {
          return std::abs(std::hypot(x - middle.x, y - middle.y) - radius) - width / 2;
        });
}

void ImageCanvas::text(ImVec2 at, std::string_view words, Rgb color) {
  if (pixels_ == nullptr) return;
  float x = std::round(at.x);
  const float y = std::round(at.y);
  for (const char *p = words.data(), *end = p + words.size(); p < end;) {
    unsigned int letter = 0;
    const int bytes = ImTextCharFromUtf8(&letter, p, end);
    p += std::max(bytes, 1);
    const ImFontGlyph* const glyph = font_.FindGlyph(static_cast<ImWchar>(letter));
    if (glyph == nullptr) continue;
    const int u0 = static_cast<int>(std::lround(glyph->U0 * static_cast<float>(atlas_width_))),
              v0 = static_cast<int>(std::lround(glyph->V0 * static_cast<float>(atlas_height_))),
              u1 = static_cast<int>(std::lround(glyph->U1 * static_cast<float>(atlas_width_))),
              v1 = static_cast<int>(std::lround(glyph->V1 * static_cast<float>(atlas_height_)));
    const int left = static_cast<int>(std::lround(x + glyph->X0)),
              top = static_cast<int>(std::lround(y + glyph->Y0));
    for (int v = v0; v < v1; ++v)
      for (int u = u0; u < u1; ++u)
        blend(
            left + u - u0, top + v - v0, color,
            static_cast<float>(pixels_[static_cast<std::size_t>(v) * static_cast<std::size_t>(atlas_width_) +
                                       static_cast<std::size_t>(u)]) /
                255);
    x += glyph->AdvanceX;
  }
}

} // namespace isoscope
