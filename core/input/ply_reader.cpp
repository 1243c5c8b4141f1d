// PLY: a header that describes elements and their properties, then the data as text or binary of either byte
// order.
#include "input/mesh_readers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

namespace isoscope {

namespace {

const std::string cut_off = "It seems cut off: get it again or export it anew.";

enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class Encoding { ascii, little_endian, big_endian };

std::size_t bytes_of(Scalar type) {
  switch (type) {
  case Scalar::i8:
  case Scalar::u8:
    return 1;
  case Scalar::i16:
  case Scalar::u16:
    return 2;
  case Scalar::i32:
  case Scalar::u32:
  case Scalar::f32:
    return 4;
  case Scalar::f64:
    return 8;
  }
  return 8;
}

struct Property {
  std::string name;
  std::optional<Scalar> list_count; ///< the type of the length, for a list
  Scalar type = Scalar::f32;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  bool vertices() const { return same_word(name, "vertex") || same_word(name, "vertices"); }
  bool faces() const { return same_word(name, "face") || same_word(name, "faces"); }
};

bool is_real(Scalar type) {
  return type == Scalar::f32 || type == Scalar::f64;
}

bool names_corners(const std::string& name) {
  constexpr std::string_view names[] = {"vertex_indices", "vertex_index", "vertex_ids",    "vertex_id",
                                        "vertex_indexes", "vertices",     "vertexindices", "vertexids",
                                        "vertex_list",    "indices",      "index"};
  return std::any_of(std::begin(names), std::end(names), [&](auto n) { return same_word(n, name); });
}

/// The list of a face's corners: by its name, or the only list of whole numbers; null when there is none.
const Property* corner_list(const Element& element) {
  const Property* only = nullptr;
  int lists = 0;
  for (const Property& p : element.properties) {
    if (!p.list_count) continue;
    if (names_corners(p.name)) return &p;
    if (is_real(p.type)) continue;
    only = &p;
    ++lists;
  }
  return lists == 1 ? only : nullptr;
}

class PlyReader {
 public:
  PlyReader(FileScanner& in, PolygonSink* sink) : in_(in), mesh_(sink) {}

  PolygonFile read() {
    read_header();
    for (const Element& element : elements_) {
      if (element.vertices()) vertex_count_ = element.count;
      has_faces_ = has_faces_ || (element.faces() && element.count > 0);
    }
    for (const Element& element : elements_) read_element(element);
    if (dropped_ > 0) mesh_.notes.push_back(dropped_points_note(dropped_, first_dropped_));
    return std::move(mesh_);
  }

 private:
  void read_header() {
    in_.word(0); // "ply"
    in_.next_line();
    bool format_seen = false;
    for (;;) {
      in_.skip_empty_lines(0);
      const std::string key(in_.word(0));
      if (key.empty()) in_.fail("ends within its header", cut_off);
      if (key == "end_header") break;
      if (key == "format") {
        read_format();
        format_seen = true;
      } else if (key == "element")
        read_element_line();
      else if (key == "property")
        read_property_line();
      else if (key != "comment" && key != "obj_info")
        in_.fail_here("\"" + printable(key) + "\" is no keyword of a PLY header", export_anew);
      in_.next_line();
    }
    if (!format_seen) in_.fail("has no format line in its header", export_anew);
    in_.next_line();
  }

  void read_format() {
    const std::string name(in_.word(0));
    if (name == "ascii")
      encoding_ = Encoding::ascii;
    else if (name == "binary_little_endian")
      encoding_ = Encoding::little_endian;
    else if (name == "binary_big_endian")
      encoding_ = Encoding::big_endian;
    else
      in_.fail_here("\"" + printable(name) + "\" is no PLY format", export_anew);
  }

  void read_element_line() {
    Element element;
    element.name = in_.word(0);
    const std::int64_t count = in_.to_integer(in_.word(0));
    if (count < 0 || count >= std::int64_t{0xffffffff})
      in_.fail_here(std::to_string(count) + " is no possible number of elements", export_anew);
    element.count = static_cast<std::uint64_t>(count);
    if (element.name == "tristrips" && count > 0)
      in_.fail("describes its faces as triangle strips", "Export it with plain faces.",
               ErrorCode::unsupported);
    elements_.push_back(element);
  }

  void read_property_line() {
    if (elements_.empty()) in_.fail_here("a property before the first element", export_anew);
    Property property;
    std::string type(in_.word(0));
    if (type == "list") {
      property.list_count = scalar(std::string(in_.word(0)));
      type = in_.word(0);
    }
    property.type = scalar(type);
    property.name = in_.word(0);
    elements_.back().properties.push_back(property);
    if (elements_.back().properties.size() > 1000) in_.fail_here("more than 1000 properties", export_anew);
  }

  Scalar scalar(const std::string& name) const {
    if (name == "char" || name == "int8") return Scalar::i8;
    if (name == "uchar" || name == "uint8") return Scalar::u8;
    if (name == "short" || name == "int16") return Scalar::i16;
    if (name == "ushort" || name == "uint16") return Scalar::u16;
    if (name == "int" || name == "int32") return Scalar::i32;
    if (name == "uint" || name == "uint32") return Scalar::u32;
    if (name == "float" || name == "float32") return Scalar::f32;
    if (name == "double" || name == "float64") return Scalar::f64;
    in_.fail_here("\"" + printable(name) + "\" is no PLY type", export_anew);
  }

  /// The fewest bytes that one row can take.
  std::uint64_t row_bytes(const Element& element) const {
    std::uint64_t bytes = 0;
    for (const Property& p : element.properties)
      bytes += encoding_ == Encoding::ascii ? 2 : bytes_of(p.list_count.value_or(p.type));
    return bytes;
  }

  void read_element(const Element& element) {
    if (element.properties.empty()) return; // nothing is stored for it, whatever its count
    const bool vertices = element.vertices();
    const Property* corners = element.faces() ? corner_list(element) : nullptr;
    in_.check_count(element.count, "rows of element " + printable(element.name), row_bytes(element),
                    vertices ? sizeof(Vec3) : 0);
    if (vertices) check_coordinates(element);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      row_ = row;
      element_ = &element;
      Vec3 point;
      for (const Property& property : element.properties) {
        if (property.list_count) {
          read_list(property, &property == corners);
          continue;
        }
        const double value = read_scalar(property.type);
        if (property.name.size() == 1 && property.name >= "x" && property.name <= "z")
          point[property.name[0] - 'x'] = value;
      }
      if (!vertices) continue;
      if (!is_finite(point)) {
        if (has_faces_)
          fail_row("has a coordinate that is not finite", "Remove such vertices or export it anew.");
        if (dropped_++ == 0 && encoding_ == Encoding::ascii) first_dropped_ = in_.line();
        continue;
      }
      mesh_.add_point(point);
    }
  }

  void check_coordinates(const Element& element) const {
    for (const std::string name : {"x", "y", "z"}) {
      const auto same = [&](const Property& p) { return p.name == name && !p.list_count; };
      if (std::none_of(element.properties.begin(), element.properties.end(), same))
        in_.fail("has vertices without the property " + name, export_anew);
    }
  }

  void read_list(const Property& property, bool corners) {
    const double length = read_scalar(*property.list_count);
    const std::uint64_t bytes = encoding_ == Encoding::ascii ? 2 : bytes_of(property.type);
    if (!(length >= 0) || length != std::floor(length))
      fail_row("has a list of impossible length", export_anew);
    if (length > static_cast<double>(in_.remaining() / bytes + 1))
      fail_row("has a list longer than the file", cut_off);
    const auto n = static_cast<std::uint64_t>(length);
    face_.clear();
    for (std::uint64_t i = 0; i < n; ++i) {
      const double value = read_scalar(property.type);
      if (!corners) continue;
      if (!(value >= 0) || value != std::floor(value) || value >= static_cast<double>(vertex_count_))
        fail_row("refers to a vertex outside 0 to " +
                     std::to_string(static_cast<std::int64_t>(vertex_count_) - 1),
                 export_anew);
      face_.push_back(static_cast<std::uint32_t>(value));
    }
    if (corners) mesh_.add_face(face_);
  }

  double read_scalar(Scalar type) {
    if (encoding_ == Encoding::ascii) {
      // Other numbers of a row, as colours or qualities, may well be "nan"; coordinates are checked by their
      // row.
      return in_.to_attribute(in_.word_across_lines("the last element", 0));
    }
    switch (type) {
    case Scalar::i8:
      return read_binary<std::int8_t>();
    case Scalar::u8:
      return read_binary<std::uint8_t>();
    case Scalar::i16:
      return read_binary<std::int16_t>();
    case Scalar::u16:
      return read_binary<std::uint16_t>();
    case Scalar::i32:
      return read_binary<std::int32_t>();
    case Scalar::u32:
      return read_binary<std::uint32_t>();
    case Scalar::f32:
      return static_cast<double>(read_binary<float>());
    case Scalar::f64:
      return read_binary<double>();
    }
    return 0;
  }

  template <class T> T read_binary() {
    std::array<char, sizeof(T)> bytes{};
    if (!in_.read(bytes.data(), bytes.size())) fail_row("is missing or incomplete: the file ends", cut_off);
    if ((encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little))
      std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  [[noreturn]] void fail_row(const std::string& what, const std::string& remedy) const {
    const std::string row = printable(element_->name) + " " + std::to_string(row_) + " " + what;
    if (encoding_ == Encoding::ascii) in_.fail_here(row, remedy);
    in_.fail(row, remedy);
  }

  FileScanner& in_;
  PolygonFile mesh_;
  Encoding encoding_ = Encoding::ascii;
  std::vector<Element> elements_;
  std::vector<std::uint32_t> face_;
  std::uint64_t vertex_count_ = 0, row_ = 0;
  bool has_faces_ = false;
  std::uint64_t dropped_ = 0, first_dropped_ = 0; ///< points that are not finite, and the first one's line
  const Element* element_ = nullptr;
};

} // namespace

PolygonFile read_ply(FileScanner& in, PolygonSink* sink) {
  return PlyReader(in, sink).read();
}

} // namespace isoscope
