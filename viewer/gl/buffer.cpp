// Buffer and vertex array objects.
#include "gl/buffer.h"

#include <glad/gl.h>

#include <utility>

namespace isoscope::gl {

Buffer::Buffer(Buffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)), bytes_(std::exchange(other.bytes_, 0)),
      capacity_(std::exchange(other.capacity_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(bytes_, other.bytes_);
  std::swap(capacity_, other.capacity_);
  return *this;
}

Buffer::~Buffer() {
  if (id_ != 0) glDeleteBuffers(1, &id_);
}

void Buffer::upload_bytes(const void* data, std::size_t bytes) {
  if (id_ == 0) glGenBuffers(1, &id_);
  // The copy target leaves the bindings of vertex arrays alone.
  glBindBuffer(GL_COPY_WRITE_BUFFER, id_);
  if (bytes > capacity_ || bytes < capacity_ / 8) {
    capacity_ = bytes + bytes / 4;
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity_), nullptr, GL_DYNAMIC_DRAW);
  }
  if (bytes > 0) glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  bytes_ = bytes;
}

VertexArray::VertexArray(VertexArray&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

VertexArray::~VertexArray() {
  if (id_ != 0) glDeleteVertexArrays(1, &id_);
}

void VertexArray::bind() {
  if (id_ == 0) glGenVertexArrays(1, &id_);
  glBindVertexArray(id_);
}

void VertexArray::attach(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes) {
  bind();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  for (const Attribute& a : attributes) {
    glEnableVertexAttribArray(a.location);
    const void* offset = reinterpret_cast<const void*>(a.offset);
    const GLsizei step = static_cast<GLsizei>(stride);
    switch (a.type) {
    case Attribute::Type::f32:
      glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, step, offset);
      break;
    case Attribute::Type::u8_normalized:
      glVertexAttribPointer(a.location, a.components, GL_UNSIGNED_BYTE, GL_TRUE, step, offset);
      break;
    case Attribute::Type::i8_normalized:
      glVertexAttribPointer(a.location, a.components, GL_BYTE, GL_TRUE, step, offset);
      break;
    case Attribute::Type::u8:
      glVertexAttribIPointer(a.location, a.components, GL_UNSIGNED_BYTE, step, offset);
      break;
    case Attribute::Type::u32:
      glVertexAttribIPointer(a.location, a.components, GL_UNSIGNED_INT, step, offset);
      break;
    }
  }
}

void VertexArray::attach_indices(const Buffer& buffer) {
  bind();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.id());
}

} // namespace isoscope::gl
