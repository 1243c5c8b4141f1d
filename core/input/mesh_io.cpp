// Tells formats apart, reads polygons and makes a sound triangle soup of them.
#include "input/mesh_io.h"

#include "input/mesh_readers.h"
#include "input/polygon.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <stdexcept>
#include <string>

namespace isoscope {

namespace {

const std::string known_formats = "Isoscope reads OFF, OBJ, PLY and STL.";
const std::string points_remedy =
    "Point sets come with a later version of Isoscope; give a triangle mesh as OFF, OBJ, PLY or STL.";

enum class Format { off, obj, ply, stl_ascii, stl_binary };

std::string lower_extension(const std::filesystem::path& file) {
  std::string e = file.extension().string();
  for (char& c : e) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return e;
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// The first word of the first line that is neither empty nor a comment, and that line.
struct FirstLine {
  std::string_view word, line;
};

FirstLine first_line(std::string_view head) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + 1, head.size()));
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    if (line.empty() || line.front() == '#') continue;
    const auto* stop = std::find_if(line.begin(), line.end(), is_space);
    return {line.substr(0, static_cast<std::size_t>(stop - line.begin())), line};
  }
  return {};
}

bool is_off_keyword(std::string_view word) {
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return false;
  const std::string_view before = word.substr(0, at), after = word.substr(at + 3);
  return before.find_first_not_of("STCN4n") == std::string_view::npos &&
         after.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::string_view keywords[] = {"v", "vn", "vt", "vp", "f",      "g",
                                           "o", "s",  "l",  "p",  "mtllib", "usemtl"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

bool looks_like_points(std::string_view line) {
  return !line.empty() && line.find_first_not_of("0123456789+-.,;eE \t\r") == std::string_view::npos;
}

/// Binary STL has no mark of its own, but its size follows from its count.
bool is_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < 84) return false;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count |= std::uint64_t{static_cast<unsigned char>(head[80 + i])} << (8 * i);
  return size == 84 + 50 * count;
}

Format detect(FileScanner& in) {
  std::string_view head = in.head();
  if (head.starts_with("\xef\xbb\xbf")) { // the byte order mark that some editors put in front of text
    in.skip(3);
    head.remove_prefix(3);
  }
  const std::string extension = lower_extension(in.file());
  const FirstLine first = first_line(head);
  if (head.starts_with("ply") && head.size() > 3 && is_space(head[3])) return Format::ply;
  if (is_off_keyword(first.word)) return Format::off;
  if (is_binary_stl(head, in.size())) return Format::stl_binary;
  if (first.word == "solid") return Format::stl_ascii;
  if (is_obj_keyword(first.word)) return Format::obj;
  const bool text = head.find('\0') == std::string_view::npos;
  if (looks_like_points(first.line))
    in.fail("holds a list of numbers, which looks like a point set", points_remedy, ErrorCode::unsupported);
  if (extension == ".stl" && !text) return Format::stl_binary;
  if (extension == ".obj" && text) return Format::obj;
  if (extension == ".off") in.fail("does not begin with the word OFF", "Is it an OFF file? Export it anew.");
  if (extension == ".ply") in.fail("does not begin with the word ply", "Is it a PLY file? Export it anew.");
  in.fail(text ? "is in no format that we know" : "holds binary data in no format that we know",
          known_formats + " Export it in one of them.");
}

PolygonFile read_polygons(FileScanner& in) {
  switch (detect(in)) {
  case Format::off:
    return read_off(in);
  case Format::obj:
    return read_obj(in);
  case Format::ply:
    return read_ply(in);
  case Format::stl_ascii:
    return read_stl_ascii(in);
  case Format::stl_binary:
    return read_stl_binary(in);
  }
  in.fail("is in no format that we know", known_formats);
}

bool has_area(const Triangle3& t) {
  return cross(t[1] - t[0], t[2] - t[0]) != Vec3{};
}

/// Triangulates, drops triangles that name a vertex twice, and refuses what is no surface at all.
TriangleSoup make_soup(const FileScanner& in, PolygonFile&& polygons) {
  TriangleSoup soup;
  soup.name = in.file().stem().string();
  if (polygons.corner_count.empty() && polygons.points.empty())
    in.fail("holds neither vertices nor faces", "Give a file with triangles.");
  if (polygons.corner_count.empty())
    in.fail("holds " + std::to_string(polygons.points.size()) + " points but no faces", points_remedy,
            ErrorCode::unsupported);

  soup.points = std::move(polygons.points);
  std::span<const std::uint32_t> corners = polygons.corners;
  for (const std::uint32_t n : polygons.corner_count) {
    triangulate_polygon(soup.points, corners.first(n), soup.triangles);
    corners = corners.subspan(n);
  }
  std::erase_if(soup.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });

  const Box3 box = soup.bounds();
  const double size = box.longest_edge();
  if (soup.triangles.empty()) in.fail("holds only degenerate faces", "Give a surface with area.");
  if (size == 0) in.fail("has all its vertices at one point", "Give a surface with area.");
  const Vec3 largest{std::max(std::abs(box.lo.x), std::abs(box.hi.x)),
                     std::max(std::abs(box.lo.y), std::abs(box.hi.y)),
                     std::max(std::abs(box.lo.z), std::abs(box.hi.z))};
  // Beyond these bounds the products of four lengths that geometry needs would leave the range of a double.
  if (std::max({largest.x, largest.y, largest.z}) > 1e60 || size < 1e-60)
    in.fail("has coordinates too large or too small to compute with", "Rescale the model to a size near 1.");
  bool any_area = false;
  for (std::size_t i = 0; i < soup.triangles.size() && !any_area; ++i) any_area = has_area(soup.triangle(i));
  if (!any_area) in.fail("holds only degenerate faces, all without area", "Give a surface with area.");
  return soup;
}

Error too_much_memory(const std::filesystem::path& file) {
  return {ErrorCode::bad_input, printable(file.native(), 1000) + ": needs more memory than this machine has.",
          "Simplify or split the model."};
}

} // namespace

Result<TriangleSoup> read_mesh(const std::filesystem::path& file) {
  try {
    FileScanner in(file);
    return make_soup(in, read_polygons(in));
  } catch (const MeshFileFailure& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return too_much_memory(file);
  } catch (const std::length_error&) {
    return too_much_memory(file);
  }
}

} // namespace isoscope
