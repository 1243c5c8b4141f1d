// Two- and three-dimensional textures.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace isoscope::gl {

enum class Format : std::uint8_t { rgba8, rgba16f, r16f, rg16f, r32f, depth };

/// Owns one texture object; movable.
class Texture {
 public:
  Texture() = default;
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  ~Texture();

  /// (Re)allocates a 2D texture; nothing happens when size and format are those it has. samples > 1:
  /// multisampled.
  void allocate(int width, int height, Format format, int samples = 1, bool linear = false);
  /// A 3D texture of one float channel, x fastest; clamped to its edge.
  void upload_volume(std::array<int, 3> size, std::span<const float> values, Format format, bool linear);
  void bind(int unit) const;

  std::uint32_t id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

 private:
  void create();
  std::uint32_t id_ = 0;
  std::uint32_t target_ = 0;
  int width_ = 0, height_ = 0, samples_ = 0;
  Format format_ = Format::rgba8;
};

} // namespace isoscope::gl
