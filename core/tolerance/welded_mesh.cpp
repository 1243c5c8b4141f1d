// Merges points by sorting them, lists edges by sorting their sides.
#include "tolerance/welded_mesh.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <tuple>

namespace isoscope {

namespace {

WeldedMesh weld(const std::vector<Vec3>& points, const std::vector<IndexTriangle>& triangles) {
  std::vector<std::uint32_t> order;
  std::vector<char> used(points.size(), 0);
  for (const auto& t : triangles)
    for (const auto v : t) used[v] = 1;
  for (std::uint32_t v = 0; v < points.size(); ++v)
    if (used[v]) order.push_back(v);
  const auto key = [&](std::uint32_t v) {
    const Vec3& p = points[v];
    return std::tuple{p.x, p.y, p.z};
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair{key(a), a} < std::pair{key(b), b};
  });
  WeldedMesh mesh;
  std::vector<std::uint32_t> merged(points.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || key(order[i]) != key(order[i - 1])) mesh.points.push_back(points[order[i]]);
    merged[order[i]] = static_cast<std::uint32_t>(mesh.points.size() - 1);
  }
  mesh.triangles.reserve(triangles.size());
  for (const auto& t : triangles) mesh.triangles.push_back({merged[t[0]], merged[t[1]], merged[t[2]]});
  return mesh;
}

} // namespace

WeldedMesh weld(const TriangleSoup& soup) {
  return weld(soup.points, soup.triangles);
}

WeldedMesh weld(const ClosestPointIndex& index) {
  std::vector<Vec3> points;
  std::vector<IndexTriangle> triangles;
  for (std::uint32_t t = 0; t < index.size(); ++t) {
    for (const Vec3 p : index.triangle(TriangleId(t))) points.push_back(p);
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return weld(points, triangles);
}

std::vector<EdgeUse> sorted_edge_uses(const std::vector<IndexTriangle>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

std::vector<EdgeUse> border_uses(const std::vector<IndexTriangle>& triangles) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(triangles);
  std::vector<EdgeUse> border;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 1 && uses[i].low != uses[i].high) border.push_back(uses[i]);
  }
  return border;
}

std::optional<std::uint32_t> vertex_of_two_fans(const WeldedMesh& mesh, const std::vector<EdgeUse>& uses) {
  // Corner 3t + i stands for triangle t at its i-th vertex.
  DisjointSets corners(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t t, std::uint32_t v) {
    const auto& tri = mesh.triangles[t];
    return 3 * t + (tri[0] == v ? 0u : (tri[1] == v ? 1u : 2u));
  };
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    if (uses[i].low != uses[i + 1].low || uses[i].high != uses[i + 1].high) continue;
    for (const auto v : {uses[i].low, uses[i].high})
      corners.unite(corner(uses[i].triangle, v), corner(uses[i + 1].triangle, v));
  }
  std::vector<char> has_fan(mesh.points.size(), 0);
  for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    if (corners.find(c) != c) continue;
    char& met = has_fan[mesh.triangles[c / 3][c % 3]];
    if (met) return mesh.triangles[c / 3][c % 3];
    met = 1;
  }
  return std::nullopt;
}

bool orient(std::vector<IndexTriangle>& triangles, const std::vector<EdgeUse>& uses) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::array<std::uint32_t, 3>> across(triangles.size(), {none, none, none}); // neighbours
  const auto link = [&](std::uint32_t from, std::uint32_t to) {
    *std::find(across[from].begin(), across[from].end() - 1, none) = to;
  };
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
    link(uses[i].triangle, uses[i + 1].triangle);
    link(uses[i + 1].triangle, uses[i].triangle);
  }
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
      for (const std::uint32_t to : across[s]) {
        if (to == none) continue;
        const bool flipped = runs_same_way(s, to);
        if (seen[to]) {
          if (flipped) return false;
          continue;
        }
        if (flipped) std::swap(triangles[to][1], triangles[to][2]);
        seen[to] = 1;
        stack.push_back(to);
      }
    }
  }
  return true;
}

} // namespace isoscope
