// Two- and three-dimensional textures.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace isoscope::gl {

/// r16s and r8s: signed, normalised to [-1, 1]; r32u: whole numbers.
enum class Format : std::uint8_t { rgba8, rgba16f, rgba32f, r16f, r16s, r8s, r32u, depth };

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
  /// A 3D texture of one channel, clamped to its edge; what it holds is not said until it is filled.
  void allocate_volume(std::array<int, 3> size, Format format, bool linear);
  /// Fills a part of it, x fastest.
  void fill_volume(std::array<int, 3> corner, std::array<int, 3> size, std::span<const std::int16_t> values);
  void fill_volume(std::array<int, 3> corner, std::array<int, 3> size, std::span<const std::int8_t> values);
  void fill_volume(std::array<int, 3> corner, std::array<int, 3> size, std::span<const std::uint32_t> values);
  void bind(int unit) const;

  std::uint32_t id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

 private:
  void create();
  void fill(std::array<int, 3> corner, std::array<int, 3> size, const void* values);
  std::uint32_t id_ = 0;
  std::uint32_t target_ = 0;
  int width_ = 0, height_ = 0, samples_ = 0;
  Format format_ = Format::rgba8;
};

} // namespace isoscope::gl
