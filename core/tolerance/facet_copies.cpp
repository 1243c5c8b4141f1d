// A quick look whether there may be copies at all, then what the edges tell.
#include "tolerance/facet_copies.h"

#include "base/scramble.h"
#include "tolerance/facet_turns.h"

#include <algorithm>
#include <bit>

namespace isoscope {
namespace {

/// The same for equal points, also where one has -0.
std::uint64_t mixed(Vec3 p) {
  std::uint64_t bits = 0;
  for (int axis = 0; axis < 3; ++axis)
    bits = scrambled(bits + golden_step + std::bit_cast<std::uint64_t>(p[axis] + 0.0));
  return bits;
}

/// Whether two triangles may have the same corners.
bool may_have_copies(const TriangleSoup& soup) {
  std::vector<std::uint64_t> of_points(soup.points.size()), of_triangles;
  std::transform(soup.points.begin(), soup.points.end(), of_points.begin(), mixed);
  of_triangles.reserve(soup.triangles.size());
  for (const auto& t : soup.triangles)
    of_triangles.push_back(of_points[t[0]] + of_points[t[1]] + of_points[t[2]]);
  std::sort(of_triangles.begin(), of_triangles.end());
  return std::adjacent_find(of_triangles.begin(), of_triangles.end()) != of_triangles.end();
}

} // namespace

std::shared_ptr<const TriangleSoup> without_needless_copies(std::shared_ptr<const TriangleSoup> soup,
                                                            const RunControl& control) {
  if (soup->gives_volume() || soup->triangles.empty() || !may_have_copies(*soup)) return soup;
  const WeldedMesh mesh = weld(*soup);
  if (control.cancelled()) return soup;
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  if (control.cancelled()) return soup;
  const std::vector<std::uint32_t> needless = needless_copies(mesh, uses);
  if (needless.empty()) return soup;
  TriangleSoup rest{soup->points, {}, soup->name};
  auto next = needless.begin();
  for (std::uint32_t t = 0; t < soup->triangles.size(); ++t) {
    if (next != needless.end() && *next == t)
      ++next;
    else
      rest.triangles.push_back(soup->triangles[t]);
  }
  return std::make_shared<const TriangleSoup>(std::move(rest));
}

} // namespace isoscope
