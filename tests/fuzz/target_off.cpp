// The OFF reader.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

std::vector<std::string> seeds() {
  return {written_mesh(".off"),
          "COFF\n5 2 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n1 1 0 1 1 1\n0.5 0.2 0 1 1 1\n0 1 0 1 1 1\n"
          "5 0 1 2 3 4 9 9 9\n3 0 1 2\n",
          "NOFF # with normals\n\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0.5 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n"};
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
