// The reader of points as rows of numbers.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

std::vector<std::string> seeds() {
  return {"0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5 0.25 -3e-1\n",
          "# a scan\n//X Y Z Nx Ny Nz\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n0 0 1 0.6 0.8 0\n",
          "5\r\n0 0 0 12 255 0 7\r\n1 0 0 40 3 4 5\r\n0 1 0 -7 0 0 0\r\n0 0 1 9 1 2 3\r\n1 1 1 9 1 2 3\r\n",
          "\"x\",\"y\",\"z\",\"intensity\"\n0,0,0,1\n1,0,0,2\n0,1,0,\n0,0,1,nan\n1,1,1,5\n",
          "0,5;1,5;2,5\n1,0;0,0;0,0\n0,0;1,0;0,0\n0,0;0,0;1,0\n",
          "x;y;z\n0;0;0\n\n1;0;0 # last of a row\nnan;0;0\n0;1;0\n0;0;1\n1;1;1;1\n",
          "4\n0 0 0 -120 10 20 30\n1 0 0 5 1 2 3\n0 1 0 6 1 2 3\n0 0 1 7 1 2 3\n4\n2 0 0 -120 0 0 0\n",
          in_utf16("0\t0\t0\n1\t0\t0\n0\t1\t0\n0\t0\t1\n")};
}

bool accepts(std::string_view bytes) {
  return accepts_mesh(bytes, ".xyz");
}

} // namespace

const Target& target() {
  static const Target made = [] {
    Target t{"xyz", seeds, number_words(), accepts, 400 << 10, 300};
    t.words.insert(t.words.end(), {",", ";", ",,", "\t", "//", "x y z", "1.#IND", "\n7\n", "0,5"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
