// The OFF reader.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

std::vector<std::string> seeds() {
  return {written_mesh(".off"),
          "COFF\n5 2 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n1 1 0 1 1 1\n0.5 0.2 0 1 1 1\n0 1 0 1 1 1\n"
          "5 0 1 2 3 4 9 9 9\n3 0 1 2\n",
          "NOFF # with normals\n\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0.5 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n",
          "off 4 4 0 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3",
          "4 1 0\r0 0 0 1 0 0\r1 1 0\r0 1 0\r4 0 1 2 3\r",
          "4 1 0\r0 0 0\r1 0 0\r1 1 0\r0 1 0\r4 0 1 2 3 nan 0.5 1\r",
          "OFF\n5 0 0\n0 0 0\n1 0 0\n0 1 0 7 7 7\n0 0 1\n# last\n0.5 1e-3 -2\n",
          "CNOFF 4 0 0\n0 0 0 0 0 1 9 9 9 9\n1 0 0 0 0 1 9 9 9 9\n0 1 0 0 0 1 9 9 9 9\n0 0 1 0 0 1 9 9 9 9\n",
          in_utf16("OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n")};
}

bool accepts(std::string_view bytes) {
  return accepts_mesh(bytes, ".off");
}

} // namespace

const Target& target() {
  static const Target made = [] {
    Target t{"off", seeds, number_words(), accepts, 400 << 10, 200};
    t.words.insert(t.words.end(), {"OFF", "ST", "4OFF", "COFF", "BINARY"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
