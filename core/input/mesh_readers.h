// One reader a file format; each leaves a scanner's bytes as polygons or throws MeshFileFailure.
#pragma once

#include "base/geometry.h"
#include "input/file_scanner.h"
#include "input/input_note.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// What a file says: points and polygons, or points alone, all indices in range, all coordinates finite.
struct PolygonFile {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> corners;      ///< of all faces, one after the other
  std::vector<std::uint32_t> corner_count; ///< of each face
  std::vector<InputNote> notes;            ///< what had to be guessed

  void add_face(std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    corner_count.push_back(static_cast<std::uint32_t>(face.size()));
  }
};

PolygonFile read_off(FileScanner& in);
PolygonFile read_obj(FileScanner& in);
PolygonFile read_ply(FileScanner& in);
PolygonFile read_stl_ascii(FileScanner& in);
PolygonFile read_stl_binary(FileScanner& in);
/// Points alone, a row of numbers each.
PolygonFile read_xyz(FileScanner& in);

/// What is said of points that were left out because some coordinate of them is no number.
InputNote dropped_points_note(std::uint64_t dropped, std::uint64_t first_line);
/// Whether a line may be the first of a list of points: numbers and what separates them.
bool looks_like_points(std::string_view line);
/// Whether the word begins an OFF file: OFF in any case, perhaps with letters before and a count behind it.
bool is_off_keyword(std::string_view word);
/// Whether the size of a file fits the count in its head, which nothing but binary STL does.
bool is_whole_binary_stl(std::string_view head, std::uint64_t size);

} // namespace isoscope
