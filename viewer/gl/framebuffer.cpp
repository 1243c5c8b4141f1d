// Framebuffer objects over textures.
#include "gl/framebuffer.h"

#include <glad/gl.h>

#include <array>
#include <utility>

namespace isoscope::gl {

Framebuffer::Framebuffer(Framebuffer&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

Framebuffer::~Framebuffer() {
  if (id_ != 0) glDeleteFramebuffers(1, &id_);
}

Status Framebuffer::attach(std::initializer_list<const Texture*> colours, const Texture* depth) {
  if (id_ == 0) glGenFramebuffers(1, &id_);
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  const auto target = [](const Texture& t) -> GLenum {
    return t.samples() > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  };
  std::array<GLenum, 4> buffers{};
  GLsizei count = 0;
  for (const Texture* colour : colours) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, target(*colour), colour->id(), 0);
    buffers[static_cast<std::size_t>(count++)] = attachment;
  }
  if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target(*depth), depth->id(), 0);
  glDrawBuffers(count, buffers.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return Error{ErrorCode::device, "The graphics driver cannot provide a picture buffer for the 3D view.",
                 "Update the graphics driver, or make the window smaller."};
  return {};
}

void Framebuffer::bind(int width, int height) const {
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glViewport(0, 0, width, height);
}

void Framebuffer::resolve_into(const Framebuffer& target, int width, int height, bool depth) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.id_);
  const GLbitfield mask = GL_COLOR_BUFFER_BIT | (depth ? GL_DEPTH_BUFFER_BIT : 0u);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, mask, GL_NEAREST);
}

} // namespace isoscope::gl
