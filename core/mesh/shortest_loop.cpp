// Shortest paths from a base, and the edges whose dual is no bridge of the dual graph without their tree.
#include "mesh/shortest_loop.h"

#include "base/parallel.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <utility>

namespace isoscope {
namespace {

constexpr std::uint32_t none = 0xffffffffu;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The edges of one component, each with its two polygons.
class Surface {
 public:
  struct Edge {
    std::array<std::uint32_t, 2> vertex{}, face{none, none};
    double length = 0;
  };
  std::vector<std::uint32_t> names; ///< local vertex -> ZeroSet
  std::vector<Edge> edges;
  std::vector<std::vector<std::uint32_t>> at_vertex, at_face; ///< edges
  bool closed = true;

  Surface(const ZeroSet& z, std::uint32_t component) {
    struct Side {
      std::uint32_t a, b, face;
      auto key() const { return std::pair(a, b); }
    };
    std::vector<Side> sides;
    std::uint32_t faces = 0;
    for (const ZeroSet::Polygon& p : z.polygons) {
      if (p.component != component) continue;
      for (std::uint8_t i = 0; i < p.count; ++i) {
        const auto [a, b] = std::minmax(p.v[i], p.v[(i + 1u) % p.count]);
        sides.push_back({a, b, faces});
        names.push_back(p.v[i]);
      }
      ++faces;
    }
    sort_unique(names);
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
      return std::pair(s.key(), s.face) < std::pair(t.key(), t.face);
    });
    at_vertex.resize(names.size());
    at_face.resize(faces);
    for (std::size_t i = 0; i < sides.size(); i += 2) {
      closed = i + 1 < sides.size() && sides[i].key() == sides[i + 1].key() &&
               (i + 2 >= sides.size() || sides[i + 2].key() != sides[i].key());
      if (!closed) return;
      Edge e;
      e.vertex = {local(sides[i].a), local(sides[i].b)};
      e.face = {sides[i].face, sides[i + 1].face};
      e.length = distance(z.vertices[sides[i].a].position, z.vertices[sides[i].b].position);
      const auto index = static_cast<std::uint32_t>(edges.size());
      for (const std::uint32_t v : e.vertex) at_vertex[v].push_back(index);
      for (const std::uint32_t f : e.face) at_face[f].push_back(index);
      edges.push_back(e);
    }
  }

  std::uint32_t across(std::uint32_t edge, std::uint32_t vertex) const {
    const auto& v = edges[edge].vertex;
    return v[0] == vertex ? v[1] : v[0];
  }
  bool has_handles() const {
    const auto euler =
        static_cast<long>(names.size()) - static_cast<long>(edges.size()) + static_cast<long>(at_face.size());
    return closed && !edges.empty() && euler < 2;
  }

 private:
  std::uint32_t local(std::uint32_t name) const {
    return static_cast<std::uint32_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin());
  }
};

/// Shortest paths from a base; ties to the smaller vertex, so that the tree is the same everywhere.
struct PathTree {
  std::vector<double> distance;
  std::vector<std::uint32_t> parent; ///< edge towards the base
  PathTree(const Surface& s, std::uint32_t base)
      : distance(s.names.size(), infinite), parent(s.names.size(), none) {
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance[base] = 0;
    queue.push({0, base});
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) continue;
      for (const std::uint32_t e : s.at_vertex[v]) {
        const std::uint32_t w = s.across(e, v);
        const double reached = d + s.edges[e].length;
        if (reached >= distance[w]) continue;
        distance[w] = reached;
        parent[w] = e;
        queue.push({reached, w});
      }
    }
  }
};

/// Which edges of the dual graph without the tree are bridges (depth first, without recursion).
std::vector<char> dual_bridges(const Surface& s, const std::vector<char>& in_tree) {
  const std::size_t faces = s.at_face.size();
  std::vector<char> bridge(s.edges.size(), 0);
  std::vector<std::uint32_t> order(faces, none), low(faces, none), entered(faces, none), next(faces, 0);
  std::vector<std::uint32_t> stack{0};
  std::uint32_t clock = 0;
  order[0] = low[0] = clock++;
  while (!stack.empty()) {
    const std::uint32_t f = stack.back();
    if (next[f] < s.at_face[f].size()) {
      const std::uint32_t e = s.at_face[f][next[f]++];
      if (in_tree[e] || e == entered[f]) continue;
      const std::uint32_t g = s.edges[e].face[0] == f ? s.edges[e].face[1] : s.edges[e].face[0];
      if (order[g] == none) {
        order[g] = low[g] = clock++;
        entered[g] = e;
        stack.push_back(g);
      } else {
        low[f] = std::min(low[f], order[g]);
      }
      continue;
    }
    stack.pop_back();
    if (stack.empty()) break;
    const std::uint32_t up = stack.back();
    low[up] = std::min(low[up], low[f]);
    if (low[f] > order[up]) bridge[entered[f]] = 1;
  }
  return bridge;
}

struct Found {
  double length = infinite;
  std::vector<std::uint32_t> vertices; ///< local
};

/// From a vertex to the base.
std::vector<std::uint32_t> path_to_base(const Surface& s, const PathTree& tree, std::uint32_t v) {
  std::vector<std::uint32_t> path{v};
  while (tree.parent[v] != none) path.push_back(v = s.across(tree.parent[v], v));
  return path;
}

Found best_through(const Surface& s, std::uint32_t base) {
  const PathTree tree(s, base);
  std::vector<char> in_tree(s.edges.size(), 0);
  for (const std::uint32_t e : tree.parent)
    if (e != none) in_tree[e] = 1;
  const std::vector<char> bridge = dual_bridges(s, in_tree);
  double shortest = infinite;
  std::uint32_t closing = none;
  for (std::uint32_t e = 0; e < s.edges.size(); ++e) {
    if (in_tree[e] || bridge[e]) continue;
    const auto& v = s.edges[e].vertex;
    const double around = tree.distance[v[0]] + tree.distance[v[1]] + s.edges[e].length;
    if (around < shortest) shortest = around, closing = e;
  }
  Found found;
  if (closing == none) return found;
  auto a = path_to_base(s, tree, s.edges[closing].vertex[0]),
       b = path_to_base(s, tree, s.edges[closing].vertex[1]);
  // The common way to the base is no part of the loop.
  while (a.size() > 1 && b.size() > 1 && a[a.size() - 2] == b[b.size() - 2]) a.pop_back(), b.pop_back();
  const double common = tree.distance[a.back()];
  found.length = shortest - 2 * common;
  found.vertices.assign(a.rbegin(), a.rend());
  found.vertices.insert(found.vertices.end(), b.begin(), b.end() - 1);
  return found;
}

} // namespace

std::optional<SurfaceLoop> shortest_handle_loop(const ZeroSet& zero_set, std::uint32_t component,
                                                std::size_t most_bases, const RunControl& control) {
  const Surface surface(zero_set, component);
  if (!surface.has_handles() || most_bases == 0) return std::nullopt;
  const std::size_t vertices = surface.names.size(), bases = std::min(most_bases, vertices);
  std::vector<Found> found(bases);
  parallel_for(bases, 1, [&](std::size_t i) {
    if (!control.cancelled())
      found[i] = best_through(surface, static_cast<std::uint32_t>(i * vertices / bases));
  });
  if (control.cancelled()) return std::nullopt;
  const auto best = std::min_element(found.begin(), found.end(),
                                     [](const Found& a, const Found& b) { return a.length < b.length; });
  if (best->vertices.empty()) return std::nullopt;
  SurfaceLoop loop;
  loop.length = best->length;
  for (const std::uint32_t v : best->vertices) loop.vertices.push_back(surface.names[v]);
  return loop;
}

} // namespace isoscope
