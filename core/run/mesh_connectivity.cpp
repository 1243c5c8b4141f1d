// Edges, fans and components, from sorted lists.
#include "run/mesh_connectivity.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace isoscope {

namespace {

/// A directed edge with the facet it bounds on its left.
struct DirectedEdge {
  std::uint32_t from, to, facet;
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

} // namespace

void check_connectivity(const TriangleMesh& mesh, bool open, Certificate& c,
                        const std::function<bool(std::uint32_t)>& counts) {
  const auto counted = [&](std::uint32_t v) { return !counts || counts(v); };
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({t[k], t[(k + 1) % 3], static_cast<std::uint32_t>(f)});
  }
  std::sort(edges.begin(), edges.end());
  const auto facets_of = [&](std::uint32_t from, std::uint32_t to) {
    const auto first = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, 0});
    auto last = first;
    while (last != edges.end() && last->from == from && last->to == to) ++last;
    return std::pair(first, last);
  };

  c.closed_manifold = c.manifold = !mesh.triangles.empty();
  c.oriented = c.manifold;
  if (mesh.triangles.empty()) c.failures.emplace_back("The mesh is empty.");
  std::size_t facets = 0;
  for (const auto& t : mesh.triangles)
    if (counted(std::min({t[0], t[1], t[2]}))) ++facets;
  for (const auto& t : mesh.triangles) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) continue;
    if (!counted(std::min({t[0], t[1], t[2]}))) continue;
    c.closed_manifold = c.manifold = c.oriented = false;
    c.failures.push_back("A facet at " + place(mesh.points[t[0]], proof_digits) + " has a vertex twice.");
    break;
  }
  DisjointSets pieces(mesh.triangles.size());
  std::size_t undirected = 0;
  for (const DirectedEdge& e : edges) {
    if (!counted(std::min(e.from, e.to))) continue;
    const auto [same, same_end] = facets_of(e.from, e.to);
    const auto [twin, twin_end] = facets_of(e.to, e.from);
    const auto along = same_end - same, against = twin_end - twin;
    const bool on_border = along == 1 && against == 0;
    if (along + against != 2) c.closed_manifold = false;
    if (along + against != 2 && !(open && on_border)) c.manifold = false;
    if (along != 1 || (against != 1 && !(open && on_border))) {
      if (c.oriented) {
        c.failures.push_back("The edge from " + place(mesh.points[e.from], proof_digits) + " to " +
                             place(mesh.points[e.to], proof_digits) +
                             " has not exactly two facets of opposite direction" +
                             (open ? ", nor is it on a border." : "."));
      }
      c.oriented = false;
    }
    if (e.from < e.to || against == 0) ++undirected;
    for (auto it = twin; it != twin_end; ++it) {
      pieces.unite(it->facet, e.facet);
    }
  }

  // Around a manifold vertex the facets form one cycle, or one fan from border to border: walking from facet
  // to facet meets all of them.
  std::vector<std::uint32_t> degree(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++degree[v];
  }
  std::size_t used = 0;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (degree[v] == 0 || !counted(v)) continue;
    ++used;
    if (!c.oriented) continue;
    auto first = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{v, 0, 0});
    for (auto e = first; open && e != edges.end() && e->from == v; ++e) {
      const auto [twin, twin_end] = facets_of(e->to, v);
      if (twin == twin_end) first = e; // the fan begins here
    }
    std::uint32_t to = first->to;
    std::uint32_t length = 0;
    do {
      const auto [next, next_end] = facets_of(v, to);
      if (next == next_end) break;
      const auto& t = mesh.triangles[next->facet];
      const std::size_t k = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
      to = t[(k + 2) % 3];
      ++length;
    } while (to != first->to && length <= degree[v]);
    if (length != degree[v]) {
      if (c.manifold) {
        c.failures.push_back("The facets around the vertex " + place(mesh.points[v], proof_digits) +
                             " form more than one fan.");
      }
      c.closed_manifold = c.manifold = false;
    }
  }
  if (!c.closed_manifold && !counts) c.boundary_loops = count_loops(border_edges(mesh), mesh.points.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (pieces.find(f) == f) ++c.components;
  }
  c.euler_characteristic =
      static_cast<long>(used) - static_cast<long>(undirected) + static_cast<long>(facets);
}

std::string name_of_region(int label) {
  return label > 0 ? "the outside" : "room " + std::to_string(-label);
}

void check_regions(const TriangleMesh& mesh, Certificate& c) {
  c.regions = certify_regions(mesh);
  c.closed_manifold = c.oriented = true;
  for (const RegionCertificate& r : c.regions) {
    c.closed_manifold = c.closed_manifold && r.closed_manifold;
    c.oriented = c.oriented && r.oriented;
    if (!r.failure.empty())
      c.failures.push_back("The boundary of " + name_of_region(r.label) + ' ' + r.failure + '.');
  }
  c.manifold = c.closed_manifold;
  DisjointSets pieces(mesh.points.size());
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      pieces.unite(a, b);
      edges.push_back({std::min(a, b), std::max(a, b)});
      used[a] = true;
    }
  sort_unique(edges);
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    ++c.euler_characteristic;
    c.components += pieces.find(v) == v ? 1 : 0;
  }
  c.euler_characteristic += static_cast<long>(mesh.triangles.size()) - static_cast<long>(edges.size());
}

} // namespace isoscope
