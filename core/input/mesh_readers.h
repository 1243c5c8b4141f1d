// One reader a file format; each leaves a scanner's bytes as polygons or throws MeshFileFailure.
#pragma once

#include "base/geometry.h"
#include "input/file_scanner.h"
#include "input/input_note.h"

#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Takes what a file says piece by piece. Faces may name points that come later; readers of what has no
/// numbers give triangles.
class PolygonSink {
 public:
  virtual ~PolygonSink() = default;
  /// The file is read from its beginning once more: what was taken does not count.
  virtual void restart() = 0;
  virtual void take_point(Vec3 p) = 0;
  virtual void take_face(std::span<const std::uint32_t> face) = 0;
  virtual void take_triangle(const Triangle3& t) = 0;
};

/// What a file says: points and polygons, or points alone, all indices in range, all coordinates finite. With
/// a sink that has all but the notes.
struct PolygonFile {
  explicit PolygonFile(PolygonSink* taker = nullptr) : sink(taker) {
    if (sink != nullptr) sink->restart();
  }
  PolygonSink* sink;
  std::uint64_t point_count = 0, face_count = 0; ///< of all
  std::vector<Vec3> points;
  std::vector<std::uint32_t> corners;      ///< of all faces, one after the other
  std::vector<std::uint32_t> corner_count; ///< of each face
  std::vector<InputNote> notes;            ///< what had to be guessed

  void add_point(Vec3 p) {
    ++point_count;
    if (sink != nullptr) return sink->take_point(p);
    points.push_back(p);
  }
  /// Of what has no numbers; there is a sink.
  void give_triangle(const Triangle3& t) {
    ++face_count;
    sink->take_triangle(t);
  }
  void add_face(std::span<const std::uint32_t> face) {
    ++face_count;
    if (sink != nullptr) return sink->take_face(face);
    corners.insert(corners.end(), face.begin(), face.end());
    corner_count.push_back(static_cast<std::uint32_t>(face.size()));
  }
};

PolygonFile read_off(FileScanner& in, PolygonSink* sink = nullptr);
PolygonFile read_obj(FileScanner& in, PolygonSink* sink = nullptr);
PolygonFile read_ply(FileScanner& in, PolygonSink* sink = nullptr);
PolygonFile read_stl_ascii(FileScanner& in, PolygonSink* sink = nullptr);
PolygonFile read_stl_binary(FileScanner& in, PolygonSink* sink = nullptr);
/// Points alone, a row of numbers each.
PolygonFile read_xyz(FileScanner& in);
/// Any of these, by content. Fails with unsupported where a sink is given and the file is rows of points.
PolygonFile read_polygons(FileScanner& in, PolygonSink* sink = nullptr);

/// What is said of points that were left out because some coordinate of them is no number.
InputNote dropped_points_note(std::uint64_t dropped, std::uint64_t first_line);
/// Whether a line may be the first of a list of points: numbers and what separates them.
bool looks_like_points(std::string_view line);
/// Whether the word begins an OFF file: OFF in any case, perhaps with letters before and a count behind it.
bool is_off_keyword(std::string_view word);
/// Whether the size of a file fits the count in its head, which nothing but binary STL does.
bool is_whole_binary_stl(std::string_view head, std::uint64_t size);

} // namespace isoscope
