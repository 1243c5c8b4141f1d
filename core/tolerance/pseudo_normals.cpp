// Sums the normals around each edge and vertex once.
#include "tolerance/pseudo_normals.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// A point this near to an edge, relative to the triangle's height over it, counts as on it.
constexpr double on_edge = 1e-9;

Vec3 normal_of(const Triangle3& c) {
  return normalized(cross(c[1] - c[0], c[2] - c[0]));
}

} // namespace

PseudoNormals::PseudoNormals(std::span<const Vec3> points, std::span<const IndexTriangle> triangles,
                             std::span<const std::int8_t> turns)
    : triangles_(triangles.begin(), triangles.end()), vertex_normals_(points.size()),
      edge_normals_(triangles.size()), turns_(turns.begin(), turns.end()) {
  const auto corners = [&](std::uint32_t t) -> Triangle3 {
    return {points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Triangle3 c = corners(t);
    const Vec3 n = turned(normal_of(c), t);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 u = normalized(c[(i + 1) % 3] - c[i]), v = normalized(c[(i + 2) % 3] - c[i]);
      const double angle = std::atan2(length(cross(u, v)), dot(u, v));
      vertex_normals_[triangles[t][i]] += angle * n;
    }
  }
  const std::vector<EdgeUse> uses = sorted_edge_uses(triangles_);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    Vec3 sum;
    for (; end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high; ++end)
      sum += turned(normal_of(corners(uses[end].triangle)), uses[end].triangle);
    for (std::size_t k = i; k < end; ++k) {
      const IndexTriangle& t = triangles_[uses[k].triangle];
      for (std::size_t j = 0; j < 3; ++j)
        if (std::min(t[j], t[(j + 1) % 3]) == uses[k].low && std::max(t[j], t[(j + 1) % 3]) == uses[k].high)
          edge_normals_[uses[k].triangle][j] = sum;
    }
  }
}

Vec3 PseudoNormals::at(TriangleId t, const Triangle3& c, Vec3 q) const {
  const Vec3 across = cross(c[1] - c[0], c[2] - c[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if (q == c[i]) return normalized(vertex_normals_[triangles_[t.index()][i]]);
  Vec3 n = turned(normalized(across), t.index());
  for (std::size_t i = 0; i < 3; ++i) {
    const double height = dot(across, cross(c[(i + 1) % 3] - c[i], q - c[i])) / squared_length(across);
    if (height < on_edge) n = normalized(edge_normals_[t.index()][i]);
  }
  return n;
}

std::size_t PseudoNormals::memory_bytes() const {
  return triangles_.capacity() * sizeof(IndexTriangle) + vertex_normals_.capacity() * sizeof(Vec3) +
         edge_normals_.capacity() * sizeof(edge_normals_[0]) + turns_.capacity();
}

} // namespace isoscope
