// Bytes through a file into read_mesh, and what a soup must keep.
#include "fuzz/mesh_target.h"

#include "fuzz/target.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"

namespace isoscope::fuzz {

namespace {

const TemporaryFolder& folder() {
  static const TemporaryFolder made;
  return made;
}

} // namespace

bool accepts_mesh(std::string_view bytes, const char* extension) {
  const auto file = folder().file("m" + std::string(extension), bytes);
  const auto soup = read_mesh(file);
  if (!soup) {
    const Error& error = soup.error();
    require(error.code != ErrorCode::internal, "the reader blames itself");
    require(error.message.find(file.string()) != std::string::npos, "an error does not name the file");
    require(error.line().find('\n') == std::string::npos, "an error has two lines");
    return false;
  }
  require(!soup->triangles.empty() || soup->points.size() >= 4, "a soup without triangles or points");
  for (const Vec3 p : soup->points) require(is_finite(p), "a coordinate that is not finite");
  for (const auto& t : soup->triangles)
    for (const auto v : t) require(v < soup->points.size(), "a corner out of range");
  return true;
}

std::string written_mesh(const char* extension) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 1.5, -3}},
                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}}};
  const auto file = folder() / ("seed" + std::string(extension));
  require(write_mesh(file, mesh).ok(), "the seed could not be written");
  return bytes_of(file);
}

std::string in_utf16(std::string_view text) {
  std::string bytes = "\xff\xfe";
  for (const char c : text) {
    bytes += c;
    bytes += '\0';
  }
  return bytes;
}

std::vector<std::string_view> number_words() {
  return {"-",  "9999999999", "4294967295", "nan",      "inf",         " ",     "\n",
          "\r", "\t",         "1e400",      "1e-400",   "1e60",        "0x1p3", "/",
          "#",  "\\\n",       "0",          "\xff\xfe", "\xef\xbb\xbf"};
}

} // namespace isoscope::fuzz
