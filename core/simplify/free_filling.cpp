// Borders as cycles, the least triangulation of each by dynamic programming, and what it would meet.
#include "simplify/free_filling.h"

#include "base/sort_unique.h"
#include "tolerance/self_intersections.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace isoscope {
namespace {

/// The time grows with the cube of the corners.
constexpr std::size_t most_corners = 400;
/// What the square of a triangle's longest edge counts beside its area.
constexpr double edge_share = 0.02;

using Cycle = std::vector<std::uint32_t>;

/// The facets of Z by vertex ids.
std::vector<IndexTriangle> triangles_of(const Complex& complex) {
  std::vector<IndexTriangle> triangles;
  for (const ZeroFacet& f : complex.facets)
    if (f.alive()) triangles.push_back({f.v[0].value, f.v[1].value, f.v[2].value});
  return triangles;
}

/// Borders against the direction of their facets, so that what fills them runs as the facets do.
std::vector<Cycle> border_cycles(const std::vector<IndexTriangle>& triangles) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const EdgeUse& use : border_uses(triangles)) next[use.to()] = use.from();
  std::vector<Cycle> cycles;
  while (!next.empty()) {
    Cycle cycle;
    for (auto at = next.begin(); at != next.end();) {
      cycle.push_back(at->first);
      const std::uint32_t to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

double cost(Vec3 a, Vec3 b, Vec3 c) {
  const double longest = std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
  return area({a, b, c}) + edge_share * longest;
}

} // namespace

std::vector<std::array<std::uint32_t, 3>>
least_triangulation(std::span<const Vec3> polygon,
                    const std::function<bool(std::size_t, std::size_t)>& forbidden) {
  const std::size_t n = polygon.size();
  if (n < 3 || n > most_corners) return {};
  constexpr double never = std::numeric_limits<double>::infinity();
  // What lies between corners i and k, with their edge; `apex` is the third corner of the triangle at it.
  std::vector<double> least(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t span = 2; span < n; ++span)
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      double& best = least[i * n + k] = never;
      if (span + 1 < n && forbidden(i, k)) continue;
      for (std::size_t j = i + 1; j < k; ++j) {
        const double sum = least[i * n + j] + least[j * n + k];
        if (sum >= best) continue;
        const double all = sum + cost(polygon[i], polygon[j], polygon[k]);
        if (all < best) best = all, apex[i * n + k] = static_cast<std::uint32_t>(j);
      }
    }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (!(least[n - 1] < never)) return triangles;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k < i + 2) continue;
    const std::uint32_t j = apex[i * n + k];
    triangles.push_back({static_cast<std::uint32_t>(i), j, static_cast<std::uint32_t>(k)});
    open.emplace_back(i, j);
    open.emplace_back(j, k);
  }
  return triangles;
}

FreeFilling fill_free_holes(const Complex& complex, const ToleranceVolume& volume, const HoleChoice& choice,
                            const std::function<bool()>& stop) {
  FreeFilling filling;
  filling.delta.facet_slots_before = static_cast<std::uint32_t>(complex.facets.size());
  const Rim& rim = volume.open_sides()->rim();
  std::vector<IndexTriangle> triangles = triangles_of(complex);
  std::vector<Vec3> points(complex.vertices.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = complex.vertices[v].position;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto add_edges = [&](const IndexTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  };
  for (const IndexTriangle& t : triangles) add_edges(t);

  for (const Cycle& cycle : border_cycles(triangles)) {
    std::map<std::uint32_t, std::size_t> votes;
    for (std::size_t i = 0; i < cycle.size(); ++i)
      ++votes[rim.loop_near(0.5 * (points[cycle[i]] + points[cycle[(i + 1) % cycle.size()]]))];
    const std::uint32_t loop = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                                 return a.second < b.second;
                               })->first;
    if (!choice.wants(loop, rim.loops()[loop])) continue;
    if (stop()) return filling;
    std::vector<Vec3> polygon;
    for (const std::uint32_t v : cycle) polygon.push_back(points[v]);
    const auto cap = least_triangulation(polygon, [&](std::size_t i, std::size_t k) {
      return edges.contains(std::minmax(cycle[i], cycle[k]));
    });
    if (cap.empty()) {
      filling.refused.push_back(
          {loop, cycle.size() > most_corners
                     ? "its border has more than " + std::to_string(most_corners) + " corners"
                     : "every disc between its corners has an edge of Z"});
      continue;
    }
    const std::size_t before = triangles.size();
    for (const auto& t : cap) triangles.push_back({cycle[t[0]], cycle[t[1]], cycle[t[2]]});
    const auto meeting = self_intersections(points, triangles, stop, 1);
    if (!meeting) return filling;
    if (!meeting->empty()) {
      triangles.resize(before);
      filling.refused.push_back({loop, "it would run through the surface"});
      continue;
    }
    for (std::size_t t = before; t < triangles.size(); ++t) {
      add_edges(triangles[t]);
      const auto slot = static_cast<std::uint32_t>(complex.facets.size() + filling.delta.added_facets.size());
      filling.delta.added_facets.push_back(
          {FacetId(slot), {VertexId(triangles[t][0]), VertexId(triangles[t][1]), VertexId(triangles[t][2])}});
    }
    filling.loops.push_back(loop);
  }
  sort_unique(filling.loops);
  return filling;
}

} // namespace isoscope
