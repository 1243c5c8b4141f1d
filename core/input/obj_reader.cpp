// OBJ: a keyword a line; vertices and faces are read, everything else that has a keyword is passed over.
#include "input/mesh_readers.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace isoscope {

namespace {

class ObjReader {
 public:
  ObjReader(FileScanner& in, PolygonSink* sink) : in_(in), mesh_(sink) {}

  PolygonFile read() {
    for (in_.skip_empty_lines(); in_.peek() != FileScanner::end_of_file; in_.skip_empty_lines()) {
      const std::string key(in_.word());
      if (key == "v")
        read_vertex();
      else if (key == "f" || key == "fo")
        read_face();
      else if (!std::isalpha(static_cast<unsigned char>(key[0])))
        in_.fail_here("\"" + printable(key) + "\" is no keyword of OBJ",
                      "Is it an OBJ file? Export it anew.");
      in_.next_line();
    }
    if (largest_ >= mesh_.point_count && largest_line_ > 0)
      in_.fail("a face on line " + std::to_string(largest_line_) + " refers to vertex " +
                   std::to_string(largest_ + 1) + ", but there are only " + std::to_string(mesh_.point_count),
               export_anew);
    if (dropped_ > 0 && mesh_.face_count > 0)
      in_.fail_at(first_dropped_, "a coordinate is not finite", "Remove such vertices or export it anew.");
    if (dropped_ > 0) {
      std::erase_if(mesh_.points, [](Vec3 p) { return !is_finite(p); });
      mesh_.notes.push_back(dropped_points_note(dropped_, first_dropped_));
    }
    return std::move(mesh_);
  }

 private:
  /// The next word of the statement; a backslash at a line's end, also one glued to a word, continues it on
  /// the next line.
  std::string_view next_word() {
    for (;;) {
      if (continued_) in_.next_line();
      continued_ = false;
      std::string_view w = in_.word();
      if (!w.ends_with('\\') || !in_.at_line_end()) return w;
      continued_ = true;
      w.remove_suffix(1);
      if (!w.empty()) return w;
    }
  }

  void read_vertex() {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view w = next_word();
      if (w.empty()) in_.fail_here("a vertex has fewer than three coordinates", export_anew);
      p[i] = in_.to_attribute(w); // faces, where there are some, show later that it must be finite
    }
    if (!is_finite(p) && dropped_++ == 0) first_dropped_ = in_.line();
    for (std::string_view w = next_word(); !w.empty(); w = next_word())
      in_.to_attribute(w); // weight or colour
    mesh_.add_point(p);
  }

  void read_face() {
    face_.clear();
    for (std::string_view w = next_word(); !w.empty(); w = next_word()) {
      const std::int64_t i = in_.to_integer(w.substr(0, w.find('/')));
      const auto count = static_cast<std::int64_t>(mesh_.point_count);
      // Counted from 1, or from the newest vertex backwards when negative.
      const std::int64_t v = i > 0 ? i - 1 : count + i;
      if (i == 0 || v < 0 || v >= std::int64_t{0xffffffff})
        in_.fail_here("a face refers to vertex " + std::to_string(i) + ", but " + std::to_string(count) +
                          " were given before",
                      export_anew);
      const auto index = static_cast<std::uint32_t>(v);
      if (index >= largest_) {
        largest_ = index;
        largest_line_ = in_.line();
      }
      face_.push_back(index);
    }
    mesh_.add_face(face_);
  }

  FileScanner& in_;
  PolygonFile mesh_;
  std::vector<std::uint32_t> face_;
  std::uint32_t largest_ = 0;
  std::uint64_t largest_line_ = 0;
  std::uint64_t dropped_ = 0, first_dropped_ = 0; ///< points that are not finite, and the first one's line
  bool continued_ = false;                        ///< the statement goes on on the next line
};

} // namespace

PolygonFile read_obj(FileScanner& in, PolygonSink* sink) {
  return ObjReader(in, sink).read();
}

} // namespace isoscope
