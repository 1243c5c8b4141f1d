// The OBJ reader.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

std::vector<std::string> seeds() {
  return {written_mesh(".obj"),
          "v 0 0 0\nv 1 0 0\nv 1 1 0 0.5\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\nf -1 -2 \\\n -3\n",
          "# a pyramid\nmtllib a.mtl\no a\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1.5\nvn 0 0 1\ng sides\n"
          "usemtl b\ns off\nf 1//1 2//1 5//1\nf 2/1/1 3/1/1 5/1/1\nf 3 4 5\nf 4 1 5\nl 1 2\nf 4 3 2 1\n",
          "v 0 0 0\rv 1 0 0\rv 0 1\\\r 0\rf 1 2\\\r3\r",
          "# points alone\no scan\nv 0 0 0 1 0.5 0\nv 1 0 0 1 0 0\nv 0 1 0 0 1 0\nvn 0 0 1\nv 0 0 1 0 0 0\np "
          "1 2 3\n",
          in_utf16("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")};
}

bool accepts(std::string_view bytes) {
  return accepts_mesh(bytes, ".obj");
}

} // namespace

const Target& target() {
  static const Target made = [] {
    Target t{"obj", seeds, number_words(), accepts, 400 << 10, 200};
    t.words.insert(t.words.end(), {"v ", "\nf ", "\nv ", "//", "-1", "g", "usemtl"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
