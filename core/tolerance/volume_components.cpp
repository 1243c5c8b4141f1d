// Components of Ω' by the distances between triangles.
#include "tolerance/volume_components.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <tuple>

namespace isoscope {
namespace {

constexpr std::uint32_t triangles_between_questions = 16;

} // namespace

VolumeComponents ClosestPointIndex::components(double r, const RunControl& control) const {
  return find_volume_components(*this, r, control);
}

VolumeComponents find_volume_components(const ClosestPointIndex& index, double r, const RunControl& control) {
  const auto n = static_cast<std::uint32_t>(index.size());
  DisjointSets sets(n);
  std::size_t count = n;

  // Equal corners first: nearly all of the work on an ordinary mesh, without a distance.
  struct Corner {
    Vec3 p;
    std::uint32_t triangle;
  };
  std::vector<Corner> corners;
  corners.reserve(3 * std::size_t{n});
  for (std::uint32_t t = 0; t < n; ++t)
    for (const Vec3 p : index.triangle(TriangleId(t))) corners.push_back({p, t});
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.p.x, a.p.y, a.p.z, a.triangle) < std::tie(b.p.x, b.p.y, b.p.z, b.triangle);
  });
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i].p == corners[i - 1].p && sets.unite(corners[i].triangle, corners[i - 1].triangle)) --count;

  SparsePoll poll(control, triangles_between_questions);
  for (std::uint32_t t = 0; t < n && count > 1 && !poll.cancelled(); ++t) {
    const Triangle3& triangle = index.triangle(TriangleId(t));
    Box3 box;
    for (const Vec3 p : triangle) box.add(p);
    for (const TriangleId other : index.triangles_in(box.grown(2 * r))) {
      if (count == 1) break;
      if (other.value <= t || sets.find(other.value) == sets.find(t)) continue;
      if (triangles_within(triangle, index.triangle(other), 2 * r) && sets.unite(t, other.value)) --count;
    }
  }

  VolumeComponents result;
  result.of_triangle.resize(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    const std::uint32_t root = sets.find(t);
    result.of_triangle[t] = root == t ? static_cast<std::uint32_t>(result.count++) : result.of_triangle[root];
  }
  return result;
}

} // namespace isoscope
