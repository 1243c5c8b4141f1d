// What small drawings need, so that the window and pictures get the same ones.
#pragma once

#include "platform/image_file.h"
#include "ui/theme.h"

#include <string_view>

namespace isoscope {

/// Lengths and places in pixels, y downwards.
class Canvas {
 public:
  /// `font`: of its texts.
  explicit Canvas(const ImFont& font) : font_(font) {}
  virtual ~Canvas() = default;
  virtual void rect(ImVec2 low, ImVec2 high, Rgb color, float alpha = 1) = 0;
  virtual void line(ImVec2 a, ImVec2 b, Rgb color, float width) = 0;
  virtual void disc(ImVec2 middle, float radius, Rgb color) = 0;
  virtual void ring(ImVec2 middle, float radius, Rgb color, float width) = 0;
  /// Small text, its top left there.
  virtual void text(ImVec2 at, std::string_view words, Rgb color) = 0;
  float text_width(std::string_view words) const;
  float text_height() const { return font_.FontSize; }

 protected:
  const ImFont& font_;
};

/// Into the present window's list.
class WindowCanvas final : public Canvas {
 public:
  explicit WindowCanvas(const ImFont& font) : Canvas(font), list_(*ImGui::GetWindowDrawList()) {}
  void rect(ImVec2 low, ImVec2 high, Rgb color, float alpha) override;
  void line(ImVec2 a, ImVec2 b, Rgb color, float width) override;
  void disc(ImVec2 middle, float radius, Rgb color) override;
  void ring(ImVec2 middle, float radius, Rgb color, float width) override;
  void text(ImVec2 at, std::string_view words, Rgb color) override;

 private:
  ImDrawList& list_;
};

/// Onto a picture, without a graphics driver; what is drawn is opaque where the picture has no ground.
class ImageCanvas final : public Canvas {
 public:
  /// The atlas owns the font and keeps its pixels.
  ImageCanvas(Image& image, ImFontAtlas& atlas, const ImFont& font);
  void rect(ImVec2 low, ImVec2 high, Rgb color, float alpha) override;
  void line(ImVec2 a, ImVec2 b, Rgb color, float width) override;
  void disc(ImVec2 middle, float radius, Rgb color) override;
  void ring(ImVec2 middle, float radius, Rgb color, float width) override;
  void text(ImVec2 at, std::string_view words, Rgb color) override;

 private:
  void blend(int x, int y, Rgb color, float alpha);
  /// Blends by the signed distance to a shape, negative inside.
  template <class Distance>
  void shape(ImVec2 low, ImVec2 high, Rgb color, float alpha, const Distance& distance);
  Image& image_;
  const unsigned char* pixels_ = nullptr; ///< of the atlas, coverage
  int atlas_width_ = 0, atlas_height_ = 0;
};

} // namespace isoscope
