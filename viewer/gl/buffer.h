// Buffer and vertex array objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace isoscope::gl {

/// Owns one buffer object; grows when needed, so that streaming the same amount again allocates nothing.
class Buffer {
 public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  ~Buffer();

  /// Replaces the contents.
  template <class T> void upload(std::span<const T> items) { upload_bytes(items.data(), items.size_bytes()); }
  std::uint32_t id() const { return id_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void upload_bytes(const void* data, std::size_t bytes);
  std::uint32_t id_ = 0;
  std::size_t bytes_ = 0, capacity_ = 0;
};

/// One vertex attribute of an interleaved buffer.
struct Attribute {
  enum class Type : std::uint8_t { f32, u8, u8_normalized, i8_normalized, u32 };
  std::uint32_t location = 0;
  int components = 1;
  Type type = Type::f32;
  std::size_t offset = 0;
};

/// Owns one vertex array object.
class VertexArray {
 public:
  VertexArray() = default;
  VertexArray(VertexArray&& other) noexcept;
  VertexArray& operator=(VertexArray&& other) noexcept;
  ~VertexArray();

  /// Sources the attributes from the buffer; `u8` and `u32` arrive as integers, the others as floats.
  void attach(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes);
  void attach_indices(const Buffer& buffer);
  void bind();

 private:
  std::uint32_t id_ = 0;
};

} // namespace isoscope::gl
