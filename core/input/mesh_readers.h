// One reader a file format; each leaves a scanner's bytes as polygons or throws MeshFileFailure.
#pragma once

#include "base/geometry.h"
#include "input/file_scanner.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// What a mesh file says: points and polygons, all indices in range, all coordinates finite.
struct PolygonFile {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> corners;      ///< of all faces, one after the other
  std::vector<std::uint32_t> corner_count; ///< of each face

  void add_face(std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    corner_count.push_back(static_cast<std::uint32_t>(face.size()));
  }
};

/// The most corners a face may have: bounds the time that triangulating it takes.
constexpr std::size_t max_face_corners = 10000;

PolygonFile read_off(FileScanner& in);
PolygonFile read_obj(FileScanner& in);
PolygonFile read_ply(FileScanner& in);
PolygonFile read_stl_ascii(FileScanner& in);
PolygonFile read_stl_binary(FileScanner& in);

} // namespace isoscope
