// Union-find over vertices.
#include "input/small_components.h"

#include "base/disjoint_sets.h"
#include "input/point_numbers.h"

#include <vector>

namespace isoscope {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Which vertices hang together.
class Components {
 public:
  /// `vertex_of` numbers the corners of triangles; `count` of them.
  template <class VertexOf>
  Components(const std::vector<Vec3>& points, const Triangles& triangles, std::size_t count,
             const VertexOf& vertex_of)
      : sets_(count), boxes_(count) {
    for (const auto& t : triangles) {
      sets_.unite(vertex_of(t[0]), vertex_of(t[1]));
      sets_.unite(vertex_of(t[0]), vertex_of(t[2]));
    }
    for (const auto& t : triangles)
      for (const auto v : t) boxes_[sets_.find(vertex_of(v))].add(points[v]);
  }
  bool represents(std::uint32_t vertex) const { return !boxes_[vertex].empty(); }
  /// Longest edge of the box of the vertex' component.
  double size(std::uint32_t vertex) { return boxes_[sets_.find(vertex)].longest_edge(); }

 private:
  DisjointSets sets_;
  std::vector<Box3> boxes_; ///< of each component, at its representative
};

} // namespace

SoupWithoutCrumbs drop_small_components(const TriangleSoup& soup, double size, const RunControl& control) {
  constexpr std::size_t poll_interval = 4096;
  SoupWithoutCrumbs result;
  std::vector<Vec3> places;
  std::vector<std::uint32_t> place_of;
  PointNumbers numbers(places);
  for (const Vec3& p : soup.points) {
    if (place_of.size() % poll_interval == 0 && control.cancelled()) return result;
    place_of.push_back(numbers.number(p));
  }
  Components components(soup.points, soup.triangles, places.size(),
                        [&](std::uint32_t v) { return place_of[v]; });
  for (std::uint32_t place = 0; place < places.size(); ++place) {
    if (!components.represents(place)) continue;
    ++result.components;
    if (components.size(place) < size) ++result.dropped_components;
  }

  result.soup.name = soup.name;
  std::vector<std::uint32_t> index(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    index[v] = static_cast<std::uint32_t>(result.soup.points.size());
    if (components.size(place_of[v]) >= size) result.soup.points.push_back(soup.points[v]);
  }
  for (const auto& t : soup.triangles) {
    if (components.size(place_of[t[0]]) < size)
      ++result.dropped_triangles;
    else
      result.soup.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  }
  return result;
}

SmallParts count_small_parts(const TriangleMesh& mesh, double size) {
  SmallParts parts;
  Components components(mesh.points, mesh.triangles, mesh.points.size(), [](std::uint32_t v) { return v; });
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (components.size(v) >= size) continue;
    ++parts.vertices;
    if (components.represents(v)) ++parts.components;
  }
  return parts;
}

} // namespace isoscope
