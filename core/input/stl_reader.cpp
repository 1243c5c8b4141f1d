// STL: triangles with their corners repeated, as text or binary; equal corners are joined again.
#include "input/mesh_readers.h"

#include "base/numbers.h"
#include "input/point_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace isoscope {

namespace {

const std::string get_again = "It seems damaged or cut off: get it again or export it anew.";
constexpr std::size_t header_bytes = 84, record_bytes = 50;

/// Keywords in any case, with or without a blank in "end loop" and the like.
class AsciiStl {
 public:
  AsciiStl(FileScanner& in, PolygonSink* sink) : in_(in), mesh_(sink) {}

  PolygonFile read() {
    for (;;) {
      in_.skip_empty_lines(0);
      if (in_.peek() == FileScanner::end_of_file) break;
      const std::string key = keyword(in_.word(0));
      if (same_word(key, "solid"))
        pass_name(); // several solids may follow one another
      else if (same_word(key, "endsolid"))
        in_.next_line();
      else if (same_word(key, "facet"))
        read_facet();
      else
        in_.fail_here("\"" + printable(key) + "\" stands where a facet is expected", export_anew);
    }
    return std::move(mesh_);
  }

 private:
  /// The word, with the next one when the two are one keyword.
  std::string keyword(std::string_view word) {
    std::string key(word);
    if (same_word(key, "end") || same_word(key, "outer")) key += in_.word_across_lines("a keyword's end", 0);
    return key;
  }

  std::string next_keyword(std::string_view expected) { return keyword(in_.word_across_lines(expected, 0)); }

  void expect(std::string_view expected) {
    const std::string key = next_keyword(expected);
    if (!same_word(key, expected))
      in_.fail_here("\"" + printable(key) + "\" stands where \"" + std::string(expected) + "\" is expected",
                    export_anew);
  }

  /// A name of any words to the end of the line, or to the first facet when that stands on the same line.
  void pass_name() {
    while (!in_.at_line_end(0)) {
      const FileScanner::Mark before = in_.mark();
      if (name_word() != "facet") continue;
      if (name_word() != "normal") continue;
      in_.return_to(before);
      return;
    }
    in_.next_line();
  }

  /// A word of a name in lower case, cut where it is too long to be a keyword.
  std::string name_word() {
    std::string word;
    in_.skip_blanks(0);
    for (int c = in_.peek(); !in_.at_word_end(); c = in_.peek()) {
      if (word.size() < 10) word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
      in_.skip(1);
    }
    return word;
  }

  void read_facet() {
    // The normal follows from the corners: whatever numbers stand for it are passed over.
    std::string key = next_keyword("outer loop");
    for (int words = 0; !same_word(key, "outerloop"); ++words) {
      if (words > 8) in_.fail_here("a facet without its outer loop", export_anew);
      key = next_keyword("outer loop");
    }
    face_.clear();
    streamed_.clear();
    for (;;) {
      key = next_keyword("endloop");
      if (same_word(key, "endloop")) break;
      if (!same_word(key, "vertex"))
        in_.fail_here("\"" + printable(key) + "\" stands where a vertex is expected", export_anew);
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = in_.to_number(in_.word_across_lines("a vertex' coordinates", 0));
      if (mesh_.sink != nullptr) {
        if (streamed_.size() < 4) streamed_.push_back(p);
      } else {
        face_.push_back(numbers_.number(p + Vec3{})); // no -0 is kept
      }
    }
    if (mesh_.sink != nullptr) return stream_facet();
    if (face_.size() < 3) in_.fail_here("a facet of fewer than three corners", export_anew);
    expect("endfacet");
    mesh_.add_face(face_);
  }

  void stream_facet() {
    if (streamed_.size() != 3) in_.fail_here("a facet of other than three corners", export_anew);
    expect("endfacet");
    mesh_.give_triangle({streamed_[0], streamed_[1], streamed_[2]});
  }

  FileScanner& in_;
  PolygonFile mesh_;
  PointNumbers numbers_{mesh_.points};
  std::vector<std::uint32_t> face_;
  std::vector<Vec3> streamed_; ///< corners of a facet for a sink
};

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Reads the triangles that are there, whatever the header announces.
class BinaryStl {
 public:
  BinaryStl(FileScanner& in, PolygonSink* sink) : in_(in), mesh_(sink) {}

  PolygonFile read() {
    std::array<char, header_bytes> header{};
    if (!in_.read(header.data(), header.size()))
      in_.fail("is shorter than the header of a binary STL file",
               "It seems cut off: get it again or export it anew.");
    announced_ = little_endian(header.data() + 80);
    const std::uint64_t whole = in_.remaining() / record_bytes, rest = in_.remaining() % record_bytes;
    // Programs that write to a pipe cannot go back to the count.
    const bool open = announced_ == 0 || announced_ == 0xffffffff;
    if (!open && announced_ > whole && rest != 0) fail_short();
    if (!open) read_announced(std::min(announced_, whole));
    passed_ = triangles_;
    read_on(whole);
    if (mesh_.face_count == 0 && announced_ > 0) fail_short();
    tell((whole - passed_) * record_bytes + rest);
    return std::move(mesh_);
  }

 private:
  using Record = std::array<char, record_bytes>;

  static Triangle3 corners(const Record& record) {
    Triangle3 t;
    for (std::size_t k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c)
        t[k][c] = static_cast<double>(std::bit_cast<float>(
            little_endian(record.data() + 12 + 12 * k + 4 * static_cast<std::size_t>(c))));
    return t;
  }

  void add(const Triangle3& t) {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) largest_ = std::max(largest_, std::abs(t[k][c]));
      if (mesh_.sink == nullptr) face[k] = numbers_.number(t[k] + Vec3{}); // no -0 is kept
    }
    ++triangles_;
    if (mesh_.sink == nullptr) return mesh_.add_face(face);
    mesh_.give_triangle(t);
  }

  void read_announced(std::uint64_t count) {
    Record record{};
    while (triangles_ < count) {
      if (!in_.read(record.data(), record.size()))
        in_.fail("ends within triangle " + std::to_string(triangles_), export_anew);
      const Triangle3 t = corners(record);
      if (!is_finite(t[0]) || !is_finite(t[1]) || !is_finite(t[2]))
        in_.fail("triangle " + std::to_string(triangles_) + " has a coordinate that is not finite",
                 export_anew);
      add(t);
    }
  }

  /// Takes what follows as triangles too, up to the first bytes that look like something else. Triangles of
  /// nothing but zeros are passed over; where they do not end they are padding.
  void read_on(std::uint64_t whole) {
    constexpr int most_zeros = 1000;
    Record record{};
    int zeros = 0;
    for (std::uint64_t i = triangles_; i < whole && in_.read(record.data(), record.size()); ++i) {
      const Triangle3 t = corners(record);
      zeros = t == Triangle3{} ? zeros + 1 : 0;
      if (zeros > most_zeros || !plausible(t)) break;
      if (zeros > 0) continue;
      add(t);
      passed_ = i + 1;
    }
  }

  bool plausible(const Triangle3& t) const {
    constexpr double first_limit = 1e9, growth = 1e3;
    const double limit = largest_ > 0 ? growth * largest_ : first_limit;
    for (const Vec3& p : t)
      for (int c = 0; c < 3; ++c)
        if (!(std::abs(p[c]) <= limit)) return false;
    return true;
  }

  [[noreturn]] void fail_short() const {
    in_.fail("announces " + std::to_string(announced_) + " triangles, which take " +
                 std::to_string(header_bytes + record_bytes * announced_) + " bytes, but has " +
                 std::to_string(in_.size()),
             get_again);
  }

  void tell(std::uint64_t left) {
    if (triangles_ != announced_ && triangles_ > 0)
      mesh_.notes.push_back({"The header of the STL file announces " + grouped(announced_) +
                             " triangles, but " + grouped(triangles_) + " are there; all of them were read." +
                             (triangles_ < announced_ ? " The file may be cut off." : "")});
    if (left > 0)
      mesh_.notes.push_back({counted(left, "byte follows", "bytes follow") +
                             " the last triangle of the STL file and " + (left == 1 ? "was" : "were") +
                             " left out."});
  }

  FileScanner& in_;
  PolygonFile mesh_;
  PointNumbers numbers_{mesh_.points};
  std::uint64_t announced_ = 0, triangles_ = 0;
  std::uint64_t passed_ = 0; ///< records up to the last triangle
  double largest_ = 0;       ///< of all coordinates so far
};

} // namespace

bool is_whole_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < header_bytes) return false;
  return size == header_bytes + record_bytes * std::uint64_t{little_endian(head.data() + 80)};
}

PolygonFile read_stl_ascii(FileScanner& in, PolygonSink* sink) {
  return AsciiStl(in, sink).read();
}

PolygonFile read_stl_binary(FileScanner& in, PolygonSink* sink) {
  return BinaryStl(in, sink).read();
}

} // namespace isoscope
