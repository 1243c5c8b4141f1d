// Normals of faces, edges and vertices that tell on which side of a surface a point lies (Bærentzen and Aanæs
// 2005).
#pragma once

#include "tolerance/welded_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace isoscope {

/// Of a welded surface: the normal of a face, the sum of those at an edge, and at a vertex the sum weighted
/// by the angles there. Seen from the closest point of a surface, a point is on the side that the normal of
/// the face, edge or vertex shows that it lies on.
class PseudoNormals {
 public:
  PseudoNormals() = default;
  /// `turns`: by triangle, +1 as it runs, -1 the other way round, 0 not at all; empty: all as they run.
  PseudoNormals(std::span<const Vec3> points, std::span<const IndexTriangle> triangles,
                std::span<const std::int8_t> turns = {});
  /// The unit normal at a point q of a triangle whose corners are given.
  Vec3 at(TriangleId t, const Triangle3& corners, Vec3 q) const;
  std::size_t memory_bytes() const;

 private:
  std::vector<IndexTriangle> triangles_;
  std::vector<Vec3> vertex_normals_;
  std::vector<std::array<Vec3, 3>> edge_normals_; ///< by triangle, from its corner i to the next
  std::vector<std::int8_t> turns_;                ///< empty: all 1

  Vec3 turned(Vec3 normal, std::size_t t) const {
    return turns_.empty() ? normal : static_cast<double>(turns_[t]) * normal;
  }
};

} // namespace isoscope
