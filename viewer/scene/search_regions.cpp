// Hatching is cut from the faces by evenly spaced planes, so that it runs on from face to face.
#include "scene/search_regions.h"

#include "scene/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace isoscope {
namespace {

using Polygon = std::vector<Vec3>;

void hatch(const Polygon& polygon, double spacing, const SceneSpace& space, Color8 tint, LineBuilder& lines) {
  const Vec3 normal = normalized(Vec3{1, 1.3, 0.7});
  double low = Box3::inf, high = -Box3::inf;
  for (const Vec3& p : polygon) {
    low = std::min(low, dot(normal, p));
    high = std::max(high, dot(normal, p));
  }
  for (double k = std::ceil(low / spacing); k * spacing < high; ++k)
    if (const auto s = cut_polygon(
            polygon.size(), [&](std::size_t i) { return dot(normal, polygon[i]) - k * spacing; },
            [&](std::size_t i, std::size_t j, double t) {
              return polygon[i] + t * (polygon[j] - polygon[i]);
            }))
      lines.segment(space.local((*s)[0]), space.local((*s)[1]), tint, 0.9f);
}

/// Edges between two facets of the polyhedron of a ball carry no meaning.
void outline(const KernelPolyhedron& shape, std::size_t ball_from, const SceneSpace& space, Color8 tint,
             LineBuilder& lines) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges; ///< whether it is one of the outline
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    for (std::size_t i = 0; i < shape.faces[f].size(); ++i) {
      const std::uint32_t a = shape.faces[f][i], b = shape.faces[f][(i + 1) % shape.faces[f].size()];
      edges[std::minmax(a, b)] |= shape.source[f] < ball_from;
    }
  for (const auto& [edge, drawn] : edges)
    if (drawn)
      lines.segment(space.local(shape.vertices[edge.first]), space.local(shape.vertices[edge.second]), tint,
                    1.5f);
}

} // namespace

void add_invalid_regions(const EdgeXray& xray, const SceneSpace& space, LineBuilder& lines,
                         MeshBuilder& faces) {
  if (xray.kernel.vertices.empty()) return;
  Box3 box;
  for (const Vec3& v : xray.kernel.vertices) box.add(v);
  const double spacing = box.longest_edge() / 32;
  const glm::vec3 color = rgb(invalid_color);
  for (const EdgeXray::Invalid& region : xray.invalid) {
    const KernelPolyhedron& shape = region.shape;
    for (const auto& face : shape.faces) {
      Polygon polygon;
      for (const std::uint32_t v : face) polygon.push_back(shape.vertices[v]);
      hatch(polygon, spacing, space, color8(color, 0.55f), lines);
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        faces.triangle(space.local(polygon[0]), space.local(polygon[i]), space.local(polygon[i + 1]),
                       color8(color, 0.1f), 0);
    }
    outline(shape, region.ball_from, space, color8(color, 0.95f), lines);
  }
}

void add_octree_cells(const CollapseAttempt& attempt, const SceneSpace& space, LineBuilder& lines) {
  constexpr double shrink = 0.94;
  for (const OctreeCell& cell : attempt.cells) {
    if (cell.fate == OctreeCell::Fate::split) continue;
    const bool faint = is_faint(cell.fate);
    const Color8 tint = color8(rgb(fate_style(cell.fate).color), faint ? 0.14f : 0.75f);
    const Vec3 c = cell.box.center(), e = 0.5 * shrink * cell.box.extent();
    const auto corner = [&](unsigned i) {
      return space.local(c + Vec3{i & 1u ? e.x : -e.x, i & 2u ? e.y : -e.y, i & 4u ? e.z : -e.z});
    };
    for (unsigned i = 0; i < 8; ++i)
      for (const unsigned bit : {1u, 2u, 4u})
        if ((i & bit) == 0) lines.segment(corner(i), corner(i | bit), tint, faint ? 0.7f : 1.0f);
  }
}

} // namespace isoscope
