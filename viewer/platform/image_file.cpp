// PNG and JPEG through stb.
#include "platform/image_file.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <fstream>
#include <iterator>

namespace isoscope {

Status write_png(const std::filesystem::path& file, const Image& image) {
  std::vector<char> bytes;
  const auto take = [](void* context, void* data, int size) {
    auto& out = *static_cast<std::vector<char>*>(context);
    const char* begin = static_cast<const char*>(data);
    out.insert(out.end(), begin, begin + size);
  };
  const std::string name = file.string();
  if (stbi_write_png_to_func(take, &bytes, image.width, image.height, 4, image.pixels.data(),
                             image.width * 4) == 0)
    return Error{ErrorCode::io, "The picture " + name + " cannot be encoded.", ""};
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out)
    return Error{ErrorCode::io, "The picture " + name + " cannot be written.",
                 "Check that the folder exists, is writable and has room."};
  return {};
}

std::optional<Image> decode_picture(std::span<const std::byte> bytes) {
  Image image;
  int channels = 0;
  stbi_uc* data =
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &image.width, &image.height, &channels, 4);
  if (data == nullptr) return std::nullopt;
  image.pixels.assign(data, data + static_cast<std::size_t>(image.width) *
                                       static_cast<std::size_t>(image.height) * 4);
  stbi_image_free(data);
  return image;
}

Result<Image> read_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return Error{ErrorCode::io, "The picture " + file.string() + " cannot be read.", ""};
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  auto image = decode_picture(std::as_bytes(std::span(bytes)));
  if (!image) return Error{ErrorCode::bad_input, file.string() + " is no picture.", ""};
  return std::move(*image);
}

} // namespace isoscope
