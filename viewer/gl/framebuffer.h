// Framebuffer objects over textures.
#pragma once

#include "base/status.h"
#include "gl/texture.h"

#include <cstdint>
#include <initializer_list>

namespace isoscope::gl {

/// Owns one framebuffer object; the textures belong to others.
class Framebuffer {
 public:
  Framebuffer() = default;
  Framebuffer(Framebuffer&& other) noexcept;
  Framebuffer& operator=(Framebuffer&& other) noexcept;
  ~Framebuffer();

  /// Attaches colour textures in order and a depth texture (may be null). Fails with device when the driver
  /// refuses.
  Status attach(std::initializer_list<const Texture*> colours, const Texture* depth);
  /// Binds for drawing and sets the viewport.
  void bind(int width, int height) const;
  /// Resolves (or copies) colour and depth of the same size into another framebuffer.
  void resolve_into(const Framebuffer& target, int width, int height, bool depth) const;
  std::uint32_t id() const { return id_; }

 private:
  std::uint32_t id_ = 0;
};

} // namespace isoscope::gl
