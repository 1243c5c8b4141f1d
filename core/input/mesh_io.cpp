// Reads polygons or points and makes a sound triangle soup of them.
#include "input/mesh_io.h"

#include "base/numbers.h"
#include "input/input_mesh.h"
#include "input/mesh_format.h"
#include "input/mesh_readers.h"
#include "input/polygon.h"

#include <algorithm>
#include <string>

namespace isoscope {

namespace {

/// Faces whose corners leave their plane by less than this part of the longest edge are called flat: so much
/// may be rounding.
constexpr double flat_enough = 1e-6;
/// Fewer points span no volume.
constexpr std::size_t fewest_points = 4;

bool has_area(const Triangle3& t) {
  return cross(t[1] - t[0], t[2] - t[0]) != Vec3{};
}

/// Faces of more than three corners, and what had to be decided about them.
struct PolygonFigures {
  std::size_t polygons = 0, bent = 0, crossing = 0;
  double largest_deviation = 0;

  std::vector<InputNote> notes() const {
    std::vector<InputNote> notes;
    if (bent > 0)
      notes.push_back(
          {grouped(bent) + " of " + grouped(polygons) + " faces of more than three corners " +
               (bent == 1 ? "is" : "are") +
               " not flat. Each is cut inside its outline, the shortest diagonals first (beyond " +
               std::to_string(most_clipped_corners) +
               " corners by a Delaunay triangulation); corners leave their face's plane by up to",
           largest_deviation});
    if (crossing > 0)
      notes.push_back({counted(crossing, "face") + " of more than " + std::to_string(most_clipped_corners) +
                       " corners " + (crossing == 1 ? "crosses itself and is" : "cross themselves and are") +
                       " cut into strips, which may leave the outline."});
    return notes;
  }
};

/// The box of all corners of faces.
Box3 box_of(const PolygonFile& polygons) {
  Box3 box;
  for (const std::uint32_t v : polygons.corners) box.add(polygons.points[v]);
  return box;
}

PolygonFigures triangulate_all(const FileScanner& in, const PolygonFile& polygons, TriangleSoup& soup) {
  PolygonFigures figures;
  const double flat = flat_enough * box_of(polygons).longest_edge();
  std::span<const std::uint32_t> corners = polygons.corners;
  for (const std::uint32_t n : polygons.corner_count) {
    const auto face = corners.first(n);
    corners = corners.subspan(n);
    if (n == 3) {
      soup.triangles.push_back({face[0], face[1], face[2]});
      continue;
    }
    if (n < 3) continue;
    ++figures.polygons;
    if (const double deviation = flatness_deviation(polygons.points, face); deviation > flat) {
      ++figures.bent;
      figures.largest_deviation = std::max(figures.largest_deviation, deviation);
    }
    if (!triangulate_polygon(polygons.points, face, in.control(), soup.triangles)) ++figures.crossing;
    if (in.control().cancelled()) in.fail("was left while its faces were cut", {}, ErrorCode::cancelled);
  }
  return figures;
}

/// Refuses what has no extent, and coordinates beyond which the products of four lengths that geometry needs
/// would leave the range of a double.
void check_size(const FileScanner& in, const Box3& box, const std::string& what, const std::string& remedy) {
  const double size = box.longest_edge();
  if (size == 0) in.fail("has all its " + what + " at one point", remedy);
  const Vec3 largest{std::max(std::abs(box.lo.x), std::abs(box.hi.x)),
                     std::max(std::abs(box.lo.y), std::abs(box.hi.y)),
                     std::max(std::abs(box.lo.z), std::abs(box.hi.z))};
  if (std::max({largest.x, largest.y, largest.z}) > 1e60 || size < 1e-60)
    in.fail("has coordinates too large or too small to compute with", "Rescale the model to a size near 1.");
}

InputMesh make_point_set(const FileScanner& in, PolygonFile&& file) {
  InputMesh mesh;
  mesh.soup.name = in.file().stem().string();
  mesh.soup.points = std::move(file.points);
  mesh.notes = std::move(file.notes);
  const std::size_t n = mesh.soup.points.size();
  if (n < fewest_points)
    in.fail("holds " + counted(n, "point") + " and no faces",
            "Give triangles, or at least " + std::to_string(fewest_points) + " points.");
  check_size(in, mesh.soup.bounds(), "points", "Give points of a surface.");
  return mesh;
}

/// Triangulates, drops triangles that name a vertex twice, and refuses what is no surface at all.
InputMesh make_soup(const FileScanner& in, PolygonFile&& polygons) {
  InputMesh mesh;
  TriangleSoup& soup = mesh.soup;
  soup.name = in.file().stem().string();
  if (polygons.corner_count.empty() && polygons.points.empty())
    in.fail("holds neither vertices nor faces", "Give a file with triangles or points.");
  if (polygons.corner_count.empty()) return make_point_set(in, std::move(polygons));

  mesh.notes = std::move(polygons.notes);
  for (InputNote& note : triangulate_all(in, polygons, soup).notes()) mesh.notes.push_back(std::move(note));
  soup.points = std::move(polygons.points);
  std::erase_if(soup.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });

  if (soup.triangles.empty()) in.fail("holds only degenerate faces", "Give a surface with area.");
  check_size(in, soup.bounds(), "vertices", "Give a surface with area.");
  bool any_area = false;
  for (std::size_t i = 0; i < soup.triangles.size() && !any_area; ++i) any_area = has_area(soup.triangle(i));
  if (!any_area) in.fail("holds only degenerate faces, all without area", "Give a surface with area.");
  return mesh;
}

} // namespace

PolygonFile read_polygons(FileScanner& in, PolygonSink* sink) {
  switch (detect_format(in)) {
  case MeshFormat::off:
    return read_off(in, sink);
  case MeshFormat::obj:
    return read_obj(in, sink);
  case MeshFormat::ply:
    return read_ply(in, sink);
  case MeshFormat::stl_ascii:
    return read_stl_ascii(in, sink);
  case MeshFormat::stl_binary:
    return read_stl_binary(in, sink);
  case MeshFormat::xyz:
    if (sink != nullptr) in.fail("has points and no faces", "Give a surface.", ErrorCode::unsupported);
    return read_xyz(in);
  }
  in.fail("is in no format that we know");
}

Result<InputMesh> read_input_mesh(const std::filesystem::path& file, const RunControl& control) {
  return scan_file(file, control, "Simplify or split the model.",
                   [](FileScanner& in) { return make_soup(in, read_polygons(in)); });
}

Result<TriangleSoup> read_mesh(const std::filesystem::path& file) {
  auto mesh = read_input_mesh(file, RunControl{});
  if (!mesh) return mesh.error();
  return std::move(mesh->soup);
}

} // namespace isoscope
