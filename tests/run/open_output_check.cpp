// Distances to all triangles and all segments, one after the other; intersections by CGAL.
#include "run/open_output_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace isoscope::test {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;
using Segments = std::vector<std::array<Vec3, 2>>;

double squared_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 u = b - a;
  const double uu = dot(u, u), t = uu > 0 ? std::clamp(dot(p - a, u) / uu, 0.0, 1.0) : 0;
  return squared_length(p - (a + t * u));
}

/// The foot of the perpendicular where it falls into the triangle, else the nearest of its edges.
double squared_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = cross(b - a, c - a);
  const double nn = dot(n, n);
  if (nn > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
      dot(cross(a - c, p - c), n) >= 0) {
    const double h = dot(p - a, n);
    return h * h / nn;
  }
  return std::min({squared_to_segment(p, a, b), squared_to_segment(p, b, c), squared_to_segment(p, c, a)});
}

class Distances {
 public:
  Distances(const TriangleSoup& soup, double delta) : soup_(soup), delta_(delta) {}

  double at(Vec3 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : soup_.triangles)
      least =
          std::min(least, squared_to_triangle(p, soup_.points[t[0]], soup_.points[t[1]], soup_.points[t[2]]));
    return std::sqrt(least);
  }

  /// A bound of the distance on a facet: δ where that is proven.
  double on(Vec3 a, Vec3 b, Vec3 c) const {
    const Vec3 middle = (1.0 / 3) * (a + b + c);
    const double radius = std::max({distance(a, middle), distance(b, middle), distance(c, middle)});
    const double d = at(middle);
    if (d + radius <= delta_) return delta_;
    if (d > delta_ || radius < 1e-3 * delta_) return d + radius;
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    double most = on(ab, bc, ca);
    for (const auto& [x, y, z] : {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}})
      if (most <= delta_ * (1 + 2e-3)) most = std::max(most, on(x, y, z));
    return most;
  }

 private:
  const TriangleSoup& soup_;
  double delta_;
};

/// The numbers of points, the same for the same places.
std::vector<std::uint32_t> merged(const std::vector<Vec3>& points) {
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> of;
  for (const Vec3 p : points)
    of.push_back(
        numbers.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(numbers.size())).first->second);
  return of;
}

Segments border_of(const std::vector<Vec3>& points, const Facets& facets) {
  const std::vector<std::uint32_t> number = merged(points);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, std::array<Vec3, 2>>> edges;
  for (const auto& t : facets)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      auto& edge = edges[std::minmax(number[a], number[b])];
      ++edge.first;
      edge.second = {points[a], points[b]};
    }
  Segments border;
  for (const auto& [ends, edge] : edges)
    if (edge.first == 1) border.push_back(edge.second);
  return border;
}

double farthest(const Segments& from, const Segments& to, double spacing) {
  double most = 0;
  for (const auto& [a, b] : from) {
    const int n = static_cast<int>(std::ceil(distance(a, b) / spacing)) + 1;
    for (int i = 0; i <= n; ++i) {
      const Vec3 p = a + (static_cast<double>(i) / n) * (b - a);
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [c, d] : to) least = std::min(least, squared_to_segment(p, c, d));
      most = std::max(most, std::sqrt(least));
    }
  }
  return most;
}

/// Sets of numbers that are joined, by the smallest way there is.
struct Joined {
  std::vector<std::uint32_t> parent;
  explicit Joined(std::size_t n) : parent(n) {
    for (std::uint32_t i = 0; i < n; ++i) parent[i] = i;
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent[find(a)] = find(b); }
};

void count(const TriangleMesh& mesh, OpenOutput& found) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> halves;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<std::map<std::uint32_t, std::uint32_t>> fan(mesh.points.size()); // by vertex: what follows
  Joined parts(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      ++halves[{a, b}];
      ++edges[std::minmax(a, b)];
      fan[a].emplace(b, t[(i + 2) % 3]);
      parts.join(a, b);
    }
  found.oriented = std::all_of(halves.begin(), halves.end(), [](const auto& h) { return h.second == 1; });
  found.manifold = std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second <= 2; });
  std::size_t used = 0;
  Joined loops(mesh.points.size());
  std::vector<std::uint8_t> on_border(mesh.points.size(), 0);
  for (const auto& [h, n] : halves)
    if (!halves.contains({h.second, h.first})) {
      loops.join(h.first, h.second);
      on_border[h.first] = on_border[h.second] = 1;
    }
  for (std::uint32_t v = 0; v < fan.size(); ++v) {
    if (fan[v].empty()) continue;
    ++used;
    found.components += parts.find(v) == v;
    found.loops += on_border[v] != 0 && loops.find(v) == v;
    // One fan: from a start that follows nothing, or any, all of it is reached.
    std::uint32_t start = fan[v].begin()->first;
    for (const auto& [b, c] : fan[v])
      if (std::none_of(fan[v].begin(), fan[v].end(), [&](const auto& f) { return f.second == b; })) start = b;
    std::size_t reached = 0;
    for (auto at = fan[v].find(start); at != fan[v].end() && reached < fan[v].size(); ++reached)
      at = fan[v].find(at->second);
    found.manifold = found.manifold && reached == fan[v].size();
  }
  found.euler_characteristic =
      static_cast<long>(used) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
}

bool meets_itself(const TriangleMesh& mesh) {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  Mesh surface;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec3 p : mesh.points) vertices.push_back(surface.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : mesh.triangles)
    if (surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == Mesh::null_face()) return true;
  return CGAL::Polygon_mesh_processing::does_self_intersect(surface);
}

} // namespace

OpenOutput check_open_output(const TriangleSoup& input, const TriangleMesh& mesh, double delta) {
  OpenOutput found;
  count(mesh, found);
  found.meets_itself = !found.manifold || !found.oriented || meets_itself(mesh);
  const Distances input_distance(input, delta);
  for (const auto& t : mesh.triangles)
    found.facets = std::max(
        found.facets, input_distance.on(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) / delta);
  const Segments rim = border_of(input.points, input.triangles),
                 border = border_of(mesh.points, mesh.triangles);
  for (const auto& [a, b] : rim)
    found.longest_rim_edge = std::max(found.longest_rim_edge, distance(a, b) / delta);
  found.to_rim = farthest(border, rim, delta / 20) / delta;
  found.from_rim = farthest(rim, border, delta / 20) / delta;
  return found;
}

} // namespace isoscope::test
