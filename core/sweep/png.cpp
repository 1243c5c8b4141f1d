// Chunks, each with its checksum; the rows packed by zlib.
#include "sweep/png.h"

#include <string_view>

#include <zlib.h>

namespace isoscope::sweep {

namespace {

void append_number(std::string& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xff);
}

void append_chunk(std::string& out, std::string_view kind, std::string_view data) {
  append_number(out, static_cast<std::uint32_t>(data.size()));
  const std::string body = std::string(kind) + std::string(data);
  out += body;
  append_number(out, static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                        static_cast<uInt>(body.size()))));
}

std::string packed(const std::string& bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string out(size, '\0');
  ::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
              bytes.size(), 9);
  out.resize(size);
  return out;
}

} // namespace

std::string png(const IndexedPicture& picture) {
  std::string out("\x89PNG\r\n\x1a\n"), head, colors, opacities, rows;
  append_number(head, picture.width);
  append_number(head, picture.height);
  head += std::string("\x08\x03\x00\x00\x00", 5); // eight bits, by a palette
  for (const Rgba& c : picture.palette) {
    for (int i = 0; i < 3; ++i) colors += static_cast<char>(c[static_cast<std::size_t>(i)]);
    opacities += static_cast<char>(c[3]);
  }
  for (std::size_t y = 0; y < picture.height; ++y) {
    rows += '\0'; // no filter
    rows.append(reinterpret_cast<const char*>(picture.pixels.data()) + y * picture.width, picture.width);
  }
  append_chunk(out, "IHDR", head);
  append_chunk(out, "PLTE", colors);
  append_chunk(out, "tRNS", opacities);
  append_chunk(out, "IDAT", packed(rows));
  append_chunk(out, "IEND", "");
  return out;
}

} // namespace isoscope::sweep
