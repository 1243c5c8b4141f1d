// STL: triangles with their corners repeated, as text or binary; equal corners are joined again.
#include "input/mesh_readers.h"

#include <array>
#include <bit>
#include <string>
#include <unordered_map>

namespace isoscope {

namespace {

const std::string export_anew = "Repair or export it anew.";

struct PointHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      h = (h ^ std::bit_cast<std::uint64_t>(p[i])) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

/// Numbers the points in the order in which they first occur.
class Welder {
 public:
  explicit Welder(PolygonFile& mesh) : mesh_(mesh) {}
  std::uint32_t index(Vec3 p) {
    for (int i = 0; i < 3; ++i) p[i] += 0.0; // -0 and 0 are one place
    const auto [place, fresh] = ids_.try_emplace(p, static_cast<std::uint32_t>(mesh_.points.size()));
    if (fresh) mesh_.points.push_back(p);
    return place->second;
  }

 private:
  PolygonFile& mesh_;
  std::unordered_map<Vec3, std::uint32_t, PointHash> ids_;
};

class AsciiStl {
 public:
  explicit AsciiStl(FileScanner& in) : in_(in) {}

  PolygonFile read() {
    in_.skip_empty_lines(0);
    in_.next_line(); // "solid" and a name of any words
    for (;;) {
      in_.skip_empty_lines(0);
      const std::string key(in_.word(0));
      if (key.empty()) break;
      if (key == "facet")
        read_facet();
      else if (key == "endsolid" || key == "solid")
        in_.next_line(); // several solids may follow one another
      else
        in_.fail_here("\"" + printable(key) + "\" stands where a facet is expected", export_anew);
    }
    return std::move(mesh_);
  }

 private:
  void expect(std::string_view keyword) {
    const std::string w(in_.word_across_lines(keyword, 0));
    if (w != keyword)
      in_.fail_here("\"" + printable(w) + "\" stands where \"" + std::string(keyword) + "\" is expected",
                    export_anew);
  }

  void read_facet() {
    in_.next_line(); // the normal follows from the corners
    expect("outer");
    expect("loop");
    face_.clear();
    for (;;) {
      const std::string key(in_.word_across_lines("endloop", 0));
      if (key == "endloop") break;
      if (key != "vertex")
        in_.fail_here("\"" + printable(key) + "\" stands where a vertex is expected", export_anew);
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = in_.to_number(in_.word_across_lines("a vertex' coordinates", 0));
      face_.push_back(welder_.index(p));
      if (face_.size() > max_face_corners)
        in_.fail_here("a facet of too many corners", "Triangulate the model first.");
    }
    if (face_.size() < 3) in_.fail_here("a facet of fewer than three corners", export_anew);
    expect("endfacet");
    mesh_.add_face(face_);
  }

  FileScanner& in_;
  PolygonFile mesh_;
  Welder welder_{mesh_};
  std::vector<std::uint32_t> face_;
};

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  return value;
}

} // namespace

PolygonFile read_stl_ascii(FileScanner& in) {
  return AsciiStl(in).read();
}

PolygonFile read_stl_binary(FileScanner& in) {
  std::array<char, 84> header{};
  if (!in.read(header.data(), header.size()))
    in.fail("is shorter than the header of a binary STL file",
            "It seems cut off: get it again or export it anew.");
  const std::uint32_t count = little_endian(header.data() + 80);
  if (in.size() != 84 + std::uint64_t{50} * count)
    in.fail("announces " + std::to_string(count) + " triangles, which take " +
                std::to_string(84 + std::uint64_t{50} * count) + " bytes, but has " +
                std::to_string(in.size()),
            "It seems damaged or cut off: get it again or export it anew.");
  PolygonFile mesh;
  Welder welder(mesh);
  std::array<char, 50> record{};
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!in.read(record.data(), record.size()))
      in.fail("ends within triangle " + std::to_string(i), export_anew);
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 p;
      for (int c = 0; c < 3; ++c)
        p[c] = static_cast<double>(std::bit_cast<float>(
            little_endian(record.data() + 12 + 12 * k + 4 * static_cast<std::size_t>(c))));
      if (!is_finite(p))
        in.fail("triangle " + std::to_string(i) + " has a coordinate that is not finite", export_anew);
      face[k] = welder.index(p);
    }
    mesh.add_face(face);
  }
  return mesh;
}

} // namespace isoscope
