// A file whose bytes are part of the program; see third_party/embed.cmake.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace isoscope {

// One embedded file. Its bytes live as long as the program and are followed by a zero that `bytes` leaves out.
struct EmbeddedFile {
  std::string_view name; // file name without folder, or the name given to isoscope_embed
  std::span<const std::byte> bytes;

  std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

// The file of that name, or null.
inline const EmbeddedFile* find_embedded(std::span<const EmbeddedFile> files, std::string_view name) {
  for (const EmbeddedFile& file : files)
    if (file.name == name) return &file;
  return nullptr;
}

} // namespace isoscope
