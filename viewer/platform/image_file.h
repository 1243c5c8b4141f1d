// Pictures as PNG files, and those that the program carries.
#pragma once

#include "base/status.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// RGBA, 8 bits a channel, rows top to bottom.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Fails with io when the file cannot be written.
Status write_png(const std::filesystem::path& file, const Image& image);
/// Fails with io when the file cannot be read, with bad_input when it is no picture.
Result<Image> read_png(const std::filesystem::path& file);
/// PNG or JPEG; nullopt when it is neither.
std::optional<Image> decode_picture(std::span<const std::byte> bytes);

} // namespace isoscope
