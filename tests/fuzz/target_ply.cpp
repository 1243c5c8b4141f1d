// The PLY reader, ascii and binary.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

/// A triangle with big-endian coordinates and a colour.
std::string big_endian() {
  using namespace std::string_literals;
  return "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float z\nproperty uchar red\nelement face 1\nproperty list uchar ushort vertex_index\nend_header\n"
         "\0\0\0\0\0\0\0\0\0\0\0\0\x01\x3f\x80\0\0\0\0\0\0\0\0\0\0\x02\0\0\0\0\x3f\x80\0\0\0\0\0\0\x03"
         "\x03\0\0\0\x01\0\x02"s;
}

/// Four points and an empty list of faces.
std::string binary_points() {
  using namespace std::string_literals;
  return "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
         "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0"
         "\0\0\0\0\0\0\0\0\0\0\x80\x3f"s;
}

std::vector<std::string> seeds() {
  return {written_mesh(".ply"),
          big_endian(),
          "ply\rformat ascii 1.0\relement vertex 3\rproperty float x\rproperty float y\rproperty float z\r"
          "element face 1\rproperty list uchar int vertex_ids\rend_header\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
          "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
          "float z\nproperty list uchar int extra\nelement face 2\nproperty list uchar int vertex_indices\n"
          "end_header\n0 0 0 1 5\n1 0 0 0\n1 1 0 0\n0 1 0 2 1 1\n4 0 1 2 3\n3 0 1 2\n",
          "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
          "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nend_header\n"
          "0 0 0 0 0 1 7\n1 0 0 0 1 0 8\nnan 0 0 nan 0 0 0\n0 1 0 1 0 0 9\n0 0 1 0 0 1 255\n",
          binary_points()};
}

bool accepts(std::string_view bytes) {
  return accepts_mesh(bytes, ".ply");
}

} // namespace

const Target& target() {
  static const Target made = [] {
    Target t{"ply", seeds, number_words(), accepts, 400 << 10, 200};
    t.words.insert(t.words.end(),
                   {"element face 99999999\n", "property double q\n", "property list uint double w\n",
                    "end_header\n", "uchar", "double", "binary_little_endian", "\xff\xff\xff\xff"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
