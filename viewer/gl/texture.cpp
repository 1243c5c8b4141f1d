// Two- and three-dimensional textures.
#include "gl/texture.h"

#include <glad/gl.h>

#include <utility>

namespace isoscope::gl {
namespace {

struct Layout {
  GLenum internal, format, type;
};

Layout layout(Format format) {
  switch (format) {
  case Format::rgba8:
    return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
  case Format::rgba16f:
    return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
  case Format::rgba32f:
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
  case Format::r16f:
    return {GL_R16F, GL_RED, GL_FLOAT};
  case Format::r16s:
    return {GL_R16_SNORM, GL_RED, GL_SHORT};
  case Format::r8s:
    return {GL_R8_SNORM, GL_RED, GL_BYTE};
  case Format::r32u:
    return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
  case Format::depth:
    return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

} // namespace

Texture::Texture(Texture&& other) noexcept {
  *this = std::move(other);
}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(target_, other.target_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(samples_, other.samples_);
  std::swap(format_, other.format_);
  return *this;
}

Texture::~Texture() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

void Texture::create() {
  if (id_ != 0) glDeleteTextures(1, &id_);
  glGenTextures(1, &id_);
}

void Texture::allocate(int width, int height, Format format, int samples, bool linear) {
  if (id_ != 0 && width == width_ && height == height_ && format == format_ && samples == samples_) return;
  create();
  width_ = width;
  height_ = height;
  format_ = format;
  samples_ = samples;
  const Layout l = layout(format);
  if (samples > 1) {
    target_ = GL_TEXTURE_2D_MULTISAMPLE;
    glBindTexture(target_, id_);
    glTexImage2DMultisample(target_, samples, l.internal, width, height, GL_TRUE);
    return;
  }
  target_ = GL_TEXTURE_2D;
  glBindTexture(target_, id_);
  glTexImage2D(target_, 0, static_cast<GLint>(l.internal), width, height, 0, l.format, l.type, nullptr);
  const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(target_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::allocate_volume(std::array<int, 3> size, Format format, bool linear) {
  create();
  target_ = GL_TEXTURE_3D;
  format_ = format;
  width_ = size[0];
  height_ = size[1];
  samples_ = 1;
  const Layout l = layout(format);
  glBindTexture(target_, id_);
  glTexImage3D(target_, 0, static_cast<GLint>(l.internal), size[0], size[1], size[2], 0, l.format, l.type,
               nullptr);
  const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(target_, wrap, GL_CLAMP_TO_EDGE);
}

void Texture::fill(std::array<int, 3> corner, std::array<int, 3> size, const void* values) {
  const Layout l = layout(format_);
  glBindTexture(target_, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(target_, 0, corner[0], corner[1], corner[2], size[0], size[1], size[2], l.format, l.type,
                  values);
}

void Texture::fill_volume(std::array<int, 3> corner, std::array<int, 3> size,
                          std::span<const std::int16_t> values) {
  fill(corner, size, values.data());
}

void Texture::fill_volume(std::array<int, 3> corner, std::array<int, 3> size,
                          std::span<const std::int8_t> values) {
  fill(corner, size, values.data());
}

void Texture::fill_volume(std::array<int, 3> corner, std::array<int, 3> size,
                          std::span<const std::uint32_t> values) {
  fill(corner, size, values.data());
}

void Texture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target_, id_);
}

} // namespace isoscope::gl
