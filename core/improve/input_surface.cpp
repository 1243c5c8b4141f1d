// Orients the input's normals like a surface next to it.
#include "improve/input_surface.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "tolerance/welded_mesh.h"

namespace isoscope {
namespace {

/// Below this share of δ a distance has no weight in an energy.
constexpr double without_weight = 0.5;

/// Union-find over the triangles: joined across edges of exactly two that run through it in opposite
/// directions.
DisjointSets consistent_pieces(const ClosestPointIndex& index) {
  const std::vector<EdgeUse> edges = sorted_edge_uses(weld(index).triangles);
  DisjointSets pieces(index.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end - i == 2 && edges[i].ascends != edges[i + 1].ascends)
      pieces.unite(edges[i].triangle, edges[i + 1].triangle);
    i = end;
  }
  return pieces;
}

} // namespace

InputSurface::InputSurface(const ToleranceField& field, double delta, const TriangleMesh& surface,
                           const RunControl& control, const BorderGate* gate, Normals normals)
    : field_(&field), gate_(gate), delta_(delta), on_surface_(1e-6 * delta), enough_(without_weight * delta),
      normals_(field.size()) {
  const bool asks_surface = field.surface() == nullptr || normals == Normals::like_surface;
  const ClosestPointIndex near_surface(asks_surface ? TriangleSoup{surface.points, surface.triangles, {}}
                                                    : TriangleSoup());
  const auto normal_near = [&](Vec3 p) {
    const ClosestPoint near = near_surface.closest(p);
    if (!near.triangle.valid()) return Vec3{};
    const Triangle3& facet = near_surface.triangle(near.triangle);
    return normalized(cross(facet[1] - facet[0], facet[2] - facet[0]));
  };
  if (field.surface() == nullptr) {
    parallel_until(field.size(), 256, control,
                   [&](std::size_t s) { normals_[s] = normal_near(field.place_of(TriangleId(s))); });
    return;
  }
  const ClosestPointIndex& index = *field.surface();
  if (normals == Normals::like_surface || FlatParts::may_be_in(index)) parts_.emplace(index, control);
  if (normals == Normals::as_given) {
    parallel_until(index.size(), 256, control, [&](std::size_t t) {
      const Triangle3& corners = index.triangle(TriangleId(t));
      normals_[t] = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    });
    return;
  }
  std::vector<double> votes(index.size());
  const bool complete = parallel_until(index.size(), 256, control, [&](std::size_t t) {
    const Triangle3& corners = index.triangle(TriangleId(t));
    const Vec3 area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    normals_[t] = normalized(area);
    votes[t] = dot(area, normal_near(centroid(corners)));
  });
  if (!complete) return;
  DisjointSets pieces = consistent_pieces(index);
  std::vector<double> sums(index.size(), 0);
  for (std::uint32_t t = 0; t < index.size(); ++t) sums[pieces.find(t)] += votes[t];
  for (std::uint32_t t = 0; t < index.size(); ++t)
    if (sums[pieces.find(t)] < 0) normals_[t] = -normals_[t];
}

} // namespace isoscope
