// Reads triangle soups and point sets from OFF, OBJ, PLY, STL, XYZ files and writes triangle meshes to the
// same formats.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

namespace isoscope {

/// Reads OFF, OBJ, PLY (ascii, binary), STL (ascii, binary) or rows of numbers, by content where the name
/// does not tell; polygons are triangulated. A list of points, or a mesh file with points but no faces, gives
/// a soup without triangles. Fails with bad_input (file, place, remedy) on anything else.
Result<TriangleSoup> read_mesh(const std::filesystem::path& file);

/// Writes by the extension: .off, .obj, .ply (binary) or .stl (binary). Goes through a temporary file in the
/// same folder, so that a full disk leaves no half-written file behind. OFF and OBJ keep every bit of the
/// coordinates. Labels, where the mesh has them, are properties of faces, "front" and "back", in PLY and
/// groups in OBJ; OFF and STL have no place for them.
Status write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh);

/// A mesh that is told piece by piece, as one that need not be in memory; each piece again as often as asked.
struct MeshSource {
  using TakePoint = std::function<void(Vec3)>;
  using TakeFacet = std::function<void(const std::array<std::uint32_t, 3>&, const Triangle3&)>;
  std::size_t vertices = 0, facets = 0;
  std::function<Status(const TakePoint&)> each_point;
  std::function<Status(const TakeFacet&)> each_facet; ///< by its points' numbers, and where these are
};
/// The same, without labels. Fails as the source does, too.
Status write_mesh(const std::filesystem::path& file, const MeshSource& source);

/// Whether write_mesh could write there now: known extension, folder exists and is writable. To be asked
/// before long work.
Status check_writable_mesh(const std::filesystem::path& file);

} // namespace isoscope
