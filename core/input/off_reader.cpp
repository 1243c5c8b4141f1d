// OFF: a header with the counts, a line for each vertex, a line for each face.
#include "input/mesh_readers.h"

#include <charconv>
#include <string>

namespace isoscope {

namespace {

struct OffHeader {
  bool homogeneous = false; ///< 4OFF: a fourth coordinate divides the others
  std::uint64_t vertices = 0, faces = 0;
};

OffHeader read_header(FileScanner& in) {
  OffHeader header;
  in.skip_empty_lines();
  std::string key(in.word());
  // Some collections of models glue the first count to the keyword: "OFF490 518 0".
  std::string first_count;
  const std::size_t off = key.find("OFF");
  if (off != std::string::npos && off + 3 < key.size()) {
    first_count = key.substr(off + 3);
    key.resize(off + 3);
  }
  const std::string prefix = key.substr(0, off);
  if (prefix.find('n') != std::string::npos)
    in.fail("is an nOFF file of other than three dimensions", "Convert it to plain OFF, OBJ, PLY or STL.",
            ErrorCode::unsupported);
  header.homogeneous = prefix.find('4') != std::string::npos;

  const auto count = [&](std::string_view what) {
    std::string w;
    w.swap(first_count);
    if (w.empty()) w = in.word_across_lines(what);
    if (w == "BINARY")
      in.fail("is a binary OFF file", "Convert it to ascii OFF or to binary PLY.", ErrorCode::unsupported);
    const std::int64_t n = in.to_integer(w);
    if (n < 0 || n >= std::int64_t{0xffffffff})
      in.fail_here(w + " is no possible number of " + std::string(what), "Repair or export it anew.");
    return static_cast<std::uint64_t>(n);
  };
  header.vertices = count("vertices");
  header.faces = count("faces");
  in.next_line();
  return header;
}

Vec3 read_vertex(FileScanner& in, bool homogeneous) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = in.to_number(in.word_across_lines("the last vertex"));
  if (homogeneous) {
    p = p / in.to_number(in.word_across_lines("the last vertex"));
    if (!is_finite(p))
      in.fail_here("the fourth coordinate makes the vertex infinite", "Remove such vertices.");
  }
  // Normals, colours and texture coordinates may follow; they must be numbers.
  while (!in.at_line_end()) in.to_number(in.word());
  in.next_line();
  return p;
}

} // namespace

PolygonFile read_off(FileScanner& in) {
  const OffHeader header = read_header(in);
  in.check_count(header.vertices, "vertices", 6, sizeof(Vec3));
  in.check_count(header.faces, "faces", 2, sizeof(std::uint32_t));

  PolygonFile mesh;
  for (std::uint64_t i = 0; i < header.vertices; ++i)
    mesh.points.push_back(read_vertex(in, header.homogeneous));
  std::vector<std::uint32_t> face;
  for (std::uint64_t i = 0; i < header.faces; ++i) {
    const std::int64_t n = in.to_integer(in.word_across_lines("the last face"));
    if (n < 0 || n > static_cast<std::int64_t>(max_face_corners))
      in.fail_here("a face of " + std::to_string(n) + " corners", "Triangulate the model first.");
    face.clear();
    for (std::int64_t k = 0; k < n; ++k) {
      const std::int64_t v = in.to_integer(in.word_across_lines("the last face"));
      if (v < 0 || static_cast<std::uint64_t>(v) >= header.vertices)
        in.fail_here("a face refers to vertex " + std::to_string(v) + ", but the vertices are 0 to " +
                         std::to_string(static_cast<std::int64_t>(header.vertices) - 1),
                     "Repair or export it anew.");
      face.push_back(static_cast<std::uint32_t>(v));
    }
    in.next_line();
    mesh.add_face(face);
  }
  return mesh;
}

} // namespace isoscope
