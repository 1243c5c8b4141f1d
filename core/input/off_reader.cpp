// OFF: a header with the counts, then vertices and faces, a line for each or however the file breaks its
// lines.
#include "input/mesh_readers.h"

#include <algorithm>
#include <string>
#include <utility>

namespace isoscope {

namespace {

bool begins_number(int c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

class OffReader {
 public:
  OffReader(FileScanner& in, PolygonSink* sink) : in_(in), sink_(sink) {}

  PolygonFile read() {
    read_header();
    in_.check_count(vertices_, "vertices", 6, sizeof(Vec3));
    in_.check_count(faces_, "faces", 2, sizeof(std::uint32_t));
    data_ = in_.mark();
    if (data_on_header_line_) return read_words();
    try {
      return read_lines();
    } catch (const MeshFileFailure& by_lines) {
      if (by_lines.error.code == ErrorCode::cancelled) throw;
      const bool too_few_lines = crowded_ && in_.peek() == FileScanner::end_of_file;
      try {
        return read_words();
      } catch (const MeshFileFailure& by_words) {
        if (too_few_lines || by_words.error.code == ErrorCode::cancelled) throw;
      }
      throw;
    }
  }

 private:
  void read_header() {
    in_.skip_empty_lines();
    std::string word(in_.word());
    if (is_off_keyword(word)) {
      // Some collections of models glue the first count to the keyword: "OFF490 518 0".
      const std::size_t end = word.find_last_not_of("0123456789") + 1;
      read_keyword(word.substr(0, end));
      word.erase(0, end);
    }
    if (word.empty()) word = in_.word_across_lines("the number of vertices");
    vertices_ = count(word, "vertices");
    const bool a_line_each = in_.at_line_end();
    faces_ = count(std::string(in_.word_across_lines("the number of faces")), "faces");
    if (a_line_each && in_.at_line_end()) in_.skip_empty_lines();
    in_.word(); // the number of edges, which nobody needs
    in_.skip_blanks();
    data_on_header_line_ = begins_number(in_.peek());
    if (!data_on_header_line_) in_.next_line();
  }

  /// The letters before OFF tell what stands with each vertex.
  void read_keyword(const std::string& keyword) {
    std::string letters = keyword.substr(0, keyword.size() - 3);
    if (letters.find('n') != std::string::npos && keyword.ends_with("OFF"))
      in_.fail("is an nOFF file of other than three dimensions", "Convert it to plain OFF, OBJ, PLY or STL.",
               ErrorCode::unsupported);
    for (const char letter : letters) {
      homogeneous_ = homogeneous_ || letter == '4';
      coloured_ = coloured_ || letter == 'C' || letter == 'c';
      if (letter == 'N' || letter == 'n') attributes_ += 3;
      if (letter == 'T' || letter == 't') attributes_ += 2; // of ST
    }
  }

  std::uint64_t count(const std::string& word, const std::string& what) const {
    if (same_word(word, "BINARY"))
      in_.fail("is a binary OFF file", "Convert it to ascii OFF or to binary PLY.", ErrorCode::unsupported);
    const std::int64_t n = in_.to_integer(word);
    if (n < 0 || n >= std::int64_t{0xffffffff})
      in_.fail_here(word + " is no possible number of " + what, export_anew);
    return static_cast<std::uint64_t>(n);
  }

  /// A line for each vertex and each face, with colours and the like behind what is needed.
  PolygonFile read_lines() {
    PolygonFile mesh(sink_);
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      add_vertex(mesh);
      std::uint64_t more = 0;
      for (; !in_.at_line_end(); ++more) in_.to_attribute(in_.word());
      crowded_ = crowded_ || more >= attributes_ + 3;
      in_.next_line();
    }
    for (std::uint64_t i = 0; i < faces_; ++i) {
      read_face(mesh);
      in_.next_line();
    }
    return finished(std::move(mesh));
  }

  /// Nothing but the numbers of vertices and faces, wherever the lines break.
  PolygonFile read_words() {
    if (!coloured_) return read_words(attributes_);
    try {
      return read_words(attributes_ + 4);
    } catch (const MeshFileFailure& with_opacity) {
      if (with_opacity.error.code == ErrorCode::cancelled) throw;
      return read_words(attributes_ + 3);
    }
  }

  PolygonFile read_words(std::uint64_t attributes) {
    in_.return_to(data_);
    dropped_ = 0;
    PolygonFile mesh(sink_);
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      add_vertex(mesh);
      for (std::uint64_t k = 0; k < attributes; ++k)
        in_.to_attribute(in_.word_across_lines("the last vertex"));
    }
    for (std::uint64_t i = 0; i < faces_; ++i) read_face(mesh);
    in_.skip_empty_lines();
    if (in_.peek() != FileScanner::end_of_file)
      in_.fail_here("more numbers follow than the header announces", export_anew);
    return finished(std::move(mesh));
  }

  /// Without faces, which would go by their numbers, vertices may be left out.
  void add_vertex(PolygonFile& mesh) {
    const Vec3 p = read_vertex();
    if (faces_ > 0 || is_finite(p))
      mesh.add_point(p);
    else if (dropped_++ == 0)
      first_dropped_ = in_.line();
  }

  PolygonFile finished(PolygonFile&& mesh) {
    if (dropped_ > 0) mesh.notes.push_back(dropped_points_note(std::exchange(dropped_, 0), first_dropped_));
    return std::move(mesh);
  }

  double to_coordinate(std::string_view word) const {
    return faces_ > 0 ? in_.to_number(word) : in_.to_attribute(word);
  }

  Vec3 read_vertex() {
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = to_coordinate(in_.word_across_lines("the last vertex"));
    if (!homogeneous_) return p;
    p = p / to_coordinate(in_.word_across_lines("the last vertex"));
    if (faces_ > 0 && !is_finite(p))
      in_.fail_here("the fourth coordinate makes the vertex infinite", "Remove such vertices.");
    return p;
  }

  void read_face(PolygonFile& mesh) {
    const std::int64_t n = in_.to_integer(in_.word_across_lines("the last face"));
    if (n < 0 || static_cast<std::uint64_t>(n) > in_.remaining() / 2 + 1)
      in_.fail_here("a face of " + std::to_string(n) + " corners, which the file does not hold", export_anew);
    face_.clear();
    for (std::int64_t k = 0; k < n; ++k) {
      const std::int64_t v = in_.to_integer(in_.word_across_lines("the last face"));
      if (v < 0 || static_cast<std::uint64_t>(v) >= vertices_)
        in_.fail_here("a face refers to vertex " + std::to_string(v) + ", but the vertices are 0 to " +
                          std::to_string(static_cast<std::int64_t>(vertices_) - 1),
                      export_anew);
      face_.push_back(static_cast<std::uint32_t>(v));
    }
    mesh.add_face(face_);
  }

  FileScanner& in_;
  PolygonSink* sink_;
  FileScanner::Mark data_;
  std::vector<std::uint32_t> face_;
  bool homogeneous_ = false; ///< 4OFF: a fourth coordinate divides the others
  bool coloured_ = false;    ///< COFF: three or four numbers behind each vertex
  bool data_on_header_line_ = false;
  bool crowded_ = false;         ///< some line could hold two vertices
  std::uint64_t attributes_ = 0; ///< other numbers that the keyword announces behind each vertex
  std::uint64_t vertices_ = 0, faces_ = 0;
  std::uint64_t dropped_ = 0, first_dropped_ = 0; ///< points that are not finite, and the first one's line
};

} // namespace

bool is_off_keyword(std::string_view word) {
  const std::size_t end = word.find_last_not_of("0123456789") + 1;
  if (end < 3 || !same_word(word.substr(end - 3, 3), "OFF")) return false;
  return word.substr(0, end - 3).find_first_not_of("STCNstcn4") == std::string_view::npos;
}

PolygonFile read_off(FileScanner& in, PolygonSink* sink) {
  return OffReader(in, sink).read();
}

} // namespace isoscope
