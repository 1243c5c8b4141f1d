// Flat convex parts of a surface: where many triangles lie in one plane, a point's distance to all of them at
// once (core/README.md, N4).
#pragma once

#include "tolerance/closest_point.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

/// Convex polygons in planes of which every point is next to some triangle. Immutable; thread-safe.
class FlatParts {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  /// Whether it is worth a look: whether of triangles that are next to each other in the index some lie in
  /// one plane. Of noisy surfaces few do.
  static bool may_be_in(const ClosestPointIndex& index);
  /// Of no use, and without any part, once the control is cancelled.
  FlatParts(const ClosestPointIndex& index, const RunControl& control);

  /// The part that a triangle lies in, but for a little; none where it is in none of several triangles.
  std::uint32_t part_of(TriangleId t) const { return of_triangle_.empty() ? none : of_triangle_[t.index()]; }
  std::size_t size() const { return parts_.size(); }
  /// The vector to p from a point of the part that is near to the nearest; nothing where none is found.
  std::optional<Vec3> away_from(std::uint32_t part, Vec3 p) const;
  /// How far points of parts may be away from the surface.
  double roughness() const { return roughness_; }

 private:
  struct Frame {
    Vec3 origin, u, v, normal;
  };
  /// x nx + y ny <= most.
  struct Half {
    double nx, ny, most;
  };
  struct Part {
    Frame frame;
    std::size_t first, last; ///< of its half-planes
  };
  struct Region;
  void divide(const Region& region, double slack);

  double roughness_ = 0, tolerance_ = 0;
  std::vector<std::uint32_t> of_triangle_;
  std::vector<Part> parts_;
  std::vector<Half> halves_;
};

} // namespace isoscope
