// Connectivity of the input after merging equal points, and its exact self-intersection test.
#include "tolerance/tolerance_volume.h"
#include "tolerance/volume_components.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace isoscope {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The soup with bitwise equal points merged and unused ones dropped.
struct MergedMesh {
  std::vector<Vec3> points;
  Triangles triangles;
};

MergedMesh merge(const TriangleSoup& soup) {
  std::vector<std::uint32_t> order;
  std::vector<char> used(soup.points.size(), 0);
  for (const auto& t : soup.triangles)
    for (const auto v : t) used[v] = 1;
  for (std::uint32_t v = 0; v < soup.points.size(); ++v)
    if (used[v]) order.push_back(v);
  const auto key = [&](std::uint32_t v) {
    const Vec3& p = soup.points[v];
    return std::tuple{p.x, p.y, p.z};
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair{key(a), a} < std::pair{key(b), b};
  });
  MergedMesh mesh;
  std::vector<std::uint32_t> merged(soup.points.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || key(order[i]) != key(order[i - 1])) mesh.points.push_back(soup.points[order[i]]);
    merged[order[i]] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
  for (const auto& t : soup.triangles) mesh.triangles.push_back({merged[t[0]], merged[t[1]], merged[t[2]]});
  return mesh;
}

/// One side of an edge: its ends in order and its triangle.
struct EdgeUse {
  std::uint32_t low, high, triangle;
};

std::vector<EdgeUse> sorted_edge_uses(const Triangles& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

/// Whether the triangles around every vertex form one fan: joining them across the edges at the vertex leaves
/// one set.
bool one_fan_each(const MergedMesh& mesh, const std::vector<EdgeUse>& uses) {
  // Corner 3t + i stands for triangle t at its i-th vertex.
  DisjointSets corners(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t t, std::uint32_t v) {
    const auto& tri = mesh.triangles[t];
    return 3 * t + (tri[0] == v ? 0u : (tri[1] == v ? 1u : 2u));
  };
  std::size_t sets = 3 * mesh.triangles.size();
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2)
    for (const auto v : {uses[i].low, uses[i].high})
      if (corners.unite(corner(uses[i].triangle, v), corner(uses[i + 1].triangle, v))) --sets;
  return sets == mesh.points.size();
}

std::size_t count_components(const MergedMesh& mesh) {
  DisjointSets sets(mesh.points.size());
  std::size_t count = mesh.points.size();
  for (const auto& t : mesh.triangles) {
    if (sets.unite(t[0], t[1])) --count;
    if (sets.unite(t[0], t[2])) --count;
  }
  return count;
}

/// Whether every two neighbours run along their edge in opposite directions.
bool consistently_oriented(const Triangles& triangles, const std::vector<EdgeUse>& uses) {
  const auto ascends = [&](const EdgeUse& use) {
    const auto& t = triangles[use.triangle];
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == use.low && t[(i + 1) % 3] == use.high) return true;
    return false;
  };
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2)
    if (ascends(uses[i]) == ascends(uses[i + 1])) return false;
  return true;
}

/// Orients the triangles consistently where that is possible; false on a one-sided surface.
bool orient(Triangles& triangles, const std::vector<EdgeUse>& uses) {
  struct Link {
    std::uint32_t from, to;
  };
  std::vector<Link> links;
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
    links.push_back({uses[i].triangle, uses[i + 1].triangle});
    links.push_back({uses[i + 1].triangle, uses[i].triangle});
  }
  std::sort(links.begin(), links.end(),
            [](const Link& a, const Link& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  const auto runs_same_way = [&](std::uint32_t s, std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (triangles[s][i] == triangles[t][j] && triangles[s][(i + 1) % 3] == triangles[t][(j + 1) % 3])
          return true;
    return false;
  };
  std::vector<char> seen(triangles.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (seen[start]) continue;
    seen[start] = 1;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t s = stack.back();
      stack.pop_back();
      auto link = std::lower_bound(links.begin(), links.end(), s,
                                   [](const Link& l, std::uint32_t t) { return l.from < t; });
      for (; link != links.end() && link->from == s; ++link) {
        const bool flipped = runs_same_way(s, link->to);
        if (seen[link->to]) {
          if (flipped) return false;
          continue;
        }
        if (flipped) std::swap(triangles[link->to][1], triangles[link->to][2]);
        seen[link->to] = 1;
        stack.push_back(link->to);
      }
    }
  }
  return true;
}

bool self_intersects(const MergedMesh& mesh, const Triangles& oriented) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh m;
  for (const Vec3 p : mesh.points) m.add_vertex({p.x, p.y, p.z});
  for (const auto& t : oriented) {
    const auto face =
        m.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    if (face == Mesh::null_face()) return true;
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(m);
}

} // namespace

InputTopology analyse_input(const TriangleSoup& soup) {
  const MergedMesh mesh = merge(soup);
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  InputTopology topology;
  topology.components = count_components(mesh);

  bool collapsed = false;
  for (const auto& t : mesh.triangles) collapsed = collapsed || t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  std::size_t edges = 0;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end, ++edges) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i != 2 && !topology.border && uses[i].low != uses[i].high)
      topology.border = 0.5 * (mesh.points[uses[i].low] + mesh.points[uses[i].high]);
  }
  if (collapsed || topology.border || !one_fan_each(mesh, uses)) return topology;

  topology.closed_manifold = true;
  topology.consistently_oriented = consistently_oriented(mesh.triangles, uses);
  topology.euler_characteristic = static_cast<long>(mesh.points.size()) - static_cast<long>(edges) +
                                  static_cast<long>(mesh.triangles.size());
  Triangles oriented = mesh.triangles;
  try {
    topology.self_intersection_free = orient(oriented, uses) && !self_intersects(mesh, oriented);
  } catch (const std::exception&) { // a degenerate face: not free of intersections as far as we can tell
    topology.self_intersection_free = false;
  }
  return topology;
}

} // namespace isoscope
