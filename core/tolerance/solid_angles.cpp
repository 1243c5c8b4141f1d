// A tree of halves along the longest side, and walks that stop at far nodes.
#include "tolerance/solid_angles.h"

#include "base/solid_angle.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace isoscope {
namespace {

constexpr std::uint32_t leaf_size = 4;
/// Nodes farther away than so many of their radii are not opened.
constexpr double far = 2;

} // namespace

void SolidAngles::Series::add(const Triangle3& t, double turn, Vec3 center) {
  const Vec3 n = turn * area_vector(t), a = t[0] - center, b = t[1] - center, c = t[2] - center;
  const Vec3 sum = a + b + c, o = sum / 3;
  area += n;
  trace += dot(n, o);
  const auto pairs = [](Vec3 v, Vec3 w) {
    return std::array{
        v.x * w.x, v.y * w.y, v.z * w.z, v.x * w.y + v.y * w.x, v.x * w.z + v.z * w.x, v.y * w.z + v.z * w.y};
  };
  const auto of_slope = pairs(n, o);
  for (std::size_t k = 0; k < slope.size(); ++k) slope[k] += of_slope[k];
  // The mean of (o·u)² over the triangle.
  std::array<double, 6> s{};
  for (const Vec3 v : {a, b, c, sum}) {
    const auto square = pairs(v, v);
    for (std::size_t k = 0; k < s.size(); ++k) s[k] += square[k] / 12;
  }
  const auto [xx, yy, zz, xy, xz, yz] = s;
  linear += Vec3{2 * xx * n.x + xy * n.y + xz * n.z, xy * n.x + 2 * yy * n.y + yz * n.z,
                 xz * n.x + yz * n.y + 2 * zz * n.z} +
            (xx + yy + zz) * n;
  const std::array<double, 10> of_bend{n.x * xx,
                                       n.y * yy,
                                       n.z * zz,
                                       n.x * xy + n.y * xx,
                                       n.x * xz + n.z * xx,
                                       n.x * yy + n.y * xy,
                                       n.y * yz + n.z * yy,
                                       n.x * zz + n.z * xz,
                                       n.y * zz + n.z * yz,
                                       n.x * yz + n.y * xz + n.z * xy};
  for (std::size_t k = 0; k < bend.size(); ++k) bend[k] += of_bend[k];
}

double SolidAngles::Series::angle(Vec3 u, double r) const {
  const auto& [xx, yy, zz, xy, xz, yz] = slope;
  const double of_slope =
      u.x * (xx * u.x + xy * u.y + xz * u.z) + u.y * (yy * u.y + yz * u.z) + zz * u.z * u.z;
  const auto& [xxx, yyy, zzz, xxy, xxz, xyy, yyz, xzz, yzz, xyz] = bend;
  const double of_bend = u.x * u.x * (xxx * u.x + xxy * u.y + xxz * u.z) +
                         u.y * u.y * (yyy * u.y + xyy * u.x + yyz * u.z) +
                         u.z * u.z * (zzz * u.z + xzz * u.x + yzz * u.y) + xyz * u.x * u.y * u.z;
  const double inverse = 1 / r;
  return inverse * inverse *
         (dot(area, u) + inverse * (trace - 3 * of_slope + inverse * (7.5 * of_bend - 1.5 * dot(linear, u))));
}

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
    sum += length(own) * middle;
    area += length(own);
    middles.add(middle);
  }
  node.center = area > 0 ? sum / area : middles.center();
  for (std::uint32_t i = first; i < last; ++i)
    node.series.add(facets_[i].corners, facets_[i].turn, node.center);
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
  SolidAngleSum near;
  double angle = 0; // of far nodes
  std::array<std::uint32_t, 64> open{};
  std::size_t count = 1; // the root
  while (count > 0) {
    const std::uint32_t at = open[--count];
    const Node& node = nodes_[at];
    const Vec3 to = node.center - p;
    const double apart = length(to);
    if (apart > far * node.radius) {
      angle += node.series.angle(to / apart, apart);
    } else if (node.second == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i) near.add(p, facets_[i].corners, facets_[i].turn);
    } else {
      open[count++] = node.second;
      open[count++] = at + 1;
    }
  }
  return near.winding() + angle / (4 * std::numbers::pi);
}

} // namespace isoscope
