// The STL readers, ascii and binary.
#include "fuzz/mesh_target.h"
#include "fuzz/target.h"

namespace isoscope::fuzz {

namespace {

/// What our writer makes, with another number of triangles in its head.
std::string counting(const char* count) {
  constexpr std::size_t header = 80;
  std::string bytes = written_mesh(".stl");
  bytes.replace(header, 4, std::string(count, 4));
  return bytes;
}

std::vector<std::string> seeds() {
  return {
      written_mesh(".stl"),
      counting("\0\0\0\0"),
      counting("\xff\xff\xff\xff"),
      counting("\3\0\0\0"),
      "solid of a binary file" + written_mesh(".stl").substr(22) + "behind it",
      "SOLID A\rFACET NORMAL 0 0 1\rOUTER LOOP\rVERTEX 0 0 0\rVERTEX 1 0 0\rVERTEX 0 1 0\rEND LOOP\r"
      "END FACET\rEND SOLID b\r",
      in_utf16("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
               "endfacet\nendsolid\n"),
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n",
      "solid\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1e-3 0 0\n   vertex 0 1.5e+2 0\n"
      "  endloop\n endfacet\n facet normal 1 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 0 1 0\n   vertex "
      "0 0 1\n"
      "  endloop\n endfacet\nendsolid\nsolid b\nendsolid b\n"};
}

bool accepts(std::string_view bytes) {
  return accepts_mesh(bytes, ".stl");
}

} // namespace

const Target& target() {
  static const Target made = [] {
    Target t{"stl", seeds, number_words(), accepts, 400 << 10, 200};
    t.words.insert(t.words.end(),
                   {"solid", "facet normal ", "vertex ", "endloop\n", "endsolid", "\xff\xff\xff\xff"});
    return t;
  }();
  return made;
}

} // namespace isoscope::fuzz
