// Orients the input's normals like a surface next to it.
#include "improve/input_surface.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"

#include <algorithm>
#include <tuple>

namespace isoscope {
namespace {

/// Below this share of δ a distance has no weight in an energy.
constexpr double without_weight = 0.5;

/// An edge of an input triangle, its ends in a fixed order.
struct SoupEdge {
  Vec3 low, high;
  std::uint32_t triangle;
  bool forward; ///< whether the triangle runs from low to high
};

auto key(const Vec3& p) {
  return std::tie(p.x, p.y, p.z);
}

/// Union-find over the triangles: joined across edges of exactly two that run through it in opposite
/// directions.
DisjointSets consistent_pieces(const ClosestPointIndex& index) {
  std::vector<SoupEdge> edges;
  edges.reserve(3 * index.size());
  for (std::uint32_t t = 0; t < index.size(); ++t) {
    const Triangle3& corners = index.triangle(TriangleId(t));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = corners[k], b = corners[(k + 1) % 3];
      const bool forward = key(a) < key(b);
      edges.push_back({forward ? a : b, forward ? b : a, t, forward});
    }
  }
  const auto same = [](const SoupEdge& a, const SoupEdge& b) { return a.low == b.low && a.high == b.high; };
  std::sort(edges.begin(), edges.end(), [](const SoupEdge& a, const SoupEdge& b) {
    return std::tuple(key(a.low), key(a.high), a.triangle) < std::tuple(key(b.low), key(b.high), b.triangle);
  });
  DisjointSets pieces(index.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && same(edges[i], edges[end])) ++end;
    if (end - i == 2 && edges[i].forward != edges[i + 1].forward)
      pieces.unite(edges[i].triangle, edges[i + 1].triangle);
    i = end;
  }
  return pieces;
}

} // namespace

InputSurface::InputSurface(const ClosestPointIndex& index, double delta, const TriangleMesh& surface,
                           const RunControl& control)
    : index_(&index), delta_(delta), on_surface_(1e-6 * delta), enough_(without_weight * delta),
      normals_(index.size()) {
  const TriangleSoup soup{surface.points, surface.triangles, {}};
  const ClosestPointIndex near_surface(soup);
  std::vector<double> votes(index.size());
  const bool complete = parallel_until(index.size(), 256, control, [&](std::size_t t) {
    const Triangle3& corners = index.triangle(TriangleId(t));
    const Vec3 area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    normals_[t] = normalized(area);
    const ClosestPoint near = near_surface.closest((corners[0] + corners[1] + corners[2]) / 3.0);
    if (!near.triangle.valid()) return;
    const Triangle3& facet = near_surface.triangle(near.triangle);
    votes[t] = dot(area, normalized(cross(facet[1] - facet[0], facet[2] - facet[0])));
  });
  if (!complete) return;
  DisjointSets pieces = consistent_pieces(index);
  std::vector<double> sums(index.size(), 0);
  for (std::uint32_t t = 0; t < index.size(); ++t) sums[pieces.find(t)] += votes[t];
  for (std::uint32_t t = 0; t < index.size(); ++t)
    if (sums[pieces.find(t)] < 0) normals_[t] = -normals_[t];
}

} // namespace isoscope
