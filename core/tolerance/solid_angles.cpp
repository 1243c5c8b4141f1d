// A tree of halves along the longest side, and walks that stop at far nodes.
#include "tolerance/solid_angles.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace isoscope {
namespace {

constexpr std::uint32_t leaf_size = 8;
/// Nodes farther away than so many of their radii count as dipoles.
constexpr double far = 3;

} // namespace

SolidAngles::SolidAngles(const ClosestPointIndex& index, std::span<const std::int8_t> turns) {
  for (std::uint32_t t = 0; t < index.size(); ++t) {
    const double turn = turns.empty() ? 1 : turns[t];
    if (turn != 0) facets_.push_back({index.triangle(TriangleId(t)), turn});
  }
  if (!facets_.empty()) build(0, static_cast<std::uint32_t>(facets_.size()));
}

void SolidAngles::build(std::uint32_t first, std::uint32_t last) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.first = first;
  node.last = last;
  Box3 middles;
  Vec3 sum;
  double area = 0;
  for (std::uint32_t i = first; i < last; ++i) {
    const Facet& f = facets_[i];
    const Vec3 middle = centroid(f.corners), own = area_vector(f.corners);
    node.area += f.turn * own;
    sum += length(own) * middle;
    area += length(own);
    middles.add(middle);
  }
  node.center = area > 0 ? sum / area : middles.center();
  for (std::uint32_t i = first; i < last; ++i)
    for (const Vec3 p : facets_[i].corners) node.radius = std::max(node.radius, distance(p, node.center));
  nodes_.push_back(node);
  if (last - first <= leaf_size) return;
  const Vec3 extent = middles.extent();
  const int axis = extent.x >= std::max(extent.y, extent.z) ? 0 : (extent.y >= extent.z ? 1 : 2);
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(facets_.begin() + first, facets_.begin() + half, facets_.begin() + last,
                   [axis](const Facet& a, const Facet& b) {
                     return centroid(a.corners)[axis] < centroid(b.corners)[axis];
                   });
  build(first, half);
  nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
  build(half, last);
}

double SolidAngles::winding(Vec3 p) const {
  if (nodes_.empty()) return 0;
  double angle = 0;
  std::array<std::uint32_t, 64> open{};
  std::size_t count = 1; // the root
  while (count > 0) {
    const std::uint32_t at = open[--count];
    const Node& node = nodes_[at];
    const Vec3 to = node.center - p;
    const double apart = length(to);
    if (apart > far * node.radius) {
      angle += dot(node.area, to) / (apart * apart * apart);
    } else if (node.second == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i)
        angle += facets_[i].turn * solid_angle(p, facets_[i].corners);
    } else {
      open[count++] = node.second;
      open[count++] = at + 1;
    }
  }
  return angle / (4 * std::numbers::pi);
}

} // namespace isoscope
