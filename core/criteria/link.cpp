// Links as sorted arrays of packed local numbers. Simplices of a ring tetrahedron are in all three links, so
// only the tetrahedra at one end can offend.
#include "criteria/link.h"

#include "base/sort_unique.h"
#include "mesh/strata.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>

namespace isoscope {

namespace {

/// Ascending local numbers of an edge or triangle, 16 bits each; a vertex or edge has leading zeros, and 0 is
/// the end a, which is in no common simplex.
using Key = std::uint64_t;

Key key(std::uint16_t u, std::uint16_t v) {
  return Key{std::min(u, v)} << 16 | std::max(u, v);
}

Key key(std::array<std::uint16_t, 3> v) {
  std::sort(v.begin(), v.end());
  return Key{v[0]} << 32 | Key{v[1]} << 16 | v[2];
}

std::vector<VertexId> vertices_of(const EdgeStar& star, Key simplex) {
  std::vector<VertexId> ids;
  for (const int shift : {32, 16, 0}) {
    const auto v = static_cast<std::uint16_t>(simplex >> shift);
    if (v != 0) ids.push_back(star.vertices[v].id);
  }
  return ids;
}

enum Mark : std::uint8_t { in_a = 1, in_b = 2, in_edge = 4 };

/// The simplices of one dimension in each of the three links.
struct Links {
  std::vector<Key> a, b, edge;
  /// Appends the simplices of both links of the ends that are not in the edge's.
  void offenders(std::vector<Key>& out) {
    sort_unique(a);
    sort_unique(b);
    sort_unique(edge);
    std::vector<Key> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    std::set_difference(common.begin(), common.end(), edge.begin(), edge.end(), std::back_inserter(out));
  }
};

/// The offenders of T; one at least when there are any, all of them when asked.
std::vector<Key> offenders_in_t(const EdgeStar& star, bool all) {
  std::vector<std::uint8_t> mark(star.vertices.size(), 0);
  for (const EdgeStar::StarTet& t : star.tets) {
    const auto m =
        static_cast<std::uint8_t>((t.at_a ? in_a : 0) | (t.at_b ? in_b : 0) | (t.ring() ? in_edge : 0));
    for (const std::uint16_t v : t.v) mark[v] |= m;
  }
  std::vector<Key> offenders;
  for (std::size_t v = 2; v < mark.size(); ++v) {
    if ((mark[v] & (in_a | in_b | in_edge)) == (in_a | in_b)) offenders.push_back(v);
    if (!offenders.empty() && !all) return offenders;
  }
  Links edges, triangles;
  for (const EdgeStar::StarTet& t : star.tets) {
    std::array<std::uint16_t, 3> common{};
    std::size_t n = 0;
    for (const std::uint16_t v : t.v) {
      if (v >= 2 && (mark[v] & in_a) && (mark[v] & in_b)) common[n++] = v;
    }
    std::vector<Key>& to = t.ring() ? edges.edge : (t.at_a ? edges.a : edges.b);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) to.push_back(key(common[i], common[j]));
    }
    if (n == 3) (t.at_a ? triangles.a : triangles.b).push_back(key(common));
  }
  edges.offenders(offenders);
  if (offenders.empty() || all) triangles.offenders(offenders);
  return offenders;
}

/// The same within the surface Z, for an edge of it.
std::vector<Key> offenders_in_zero_set(std::span<const StarFacet> facets) {
  Links vertices, edges;
  for (const StarFacet& f : facets) {
    std::array<std::uint16_t, 2> rest{};
    std::size_t n = 0;
    for (const std::uint16_t v : f.v) {
      if (v >= 2) rest[n++] = v;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (f.at_a) vertices.a.push_back(rest[i]);
      if (f.at_b) vertices.b.push_back(rest[i]);
      if (f.ring()) vertices.edge.push_back(rest[i]);
    }
    if (n == 2) (f.at_a ? edges.a : edges.b).push_back(key(rest[0], rest[1]));
  }
  std::vector<Key> offenders;
  vertices.offenders(offenders);
  edges.offenders(offenders);
  return offenders;
}

/// The same within the curves of Z: what both ends are joined to by curves. 0 stands for ab itself: it is no
/// curve though both ends are on some, or both are points.
std::vector<Key> offenders_on_curves(const EdgeStar& star, std::span<const StarFacet> facets) {
  const EdgeStrata strata = strata_of(star);
  if (strata.a > Stratum::curve || strata.b > Stratum::curve) return {};
  if (strata.edge != Stratum::curve || (strata.a == Stratum::point && strata.b == Stratum::point)) return {0};
  const std::vector<std::uint32_t> a = curves_from(link_arcs(facets, 0)),
                                   b = curves_from(link_arcs(facets, 1));
  std::vector<Key> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

} // namespace

LinkVerdict check_link(const EdgeStar& star, bool list_offenders) {
  LinkVerdict verdict;
  const std::vector<Key> in_t = offenders_in_t(star, list_offenders);
  verdict.holds_in_t = in_t.empty();
  if (list_offenders) {
    for (const Key k : in_t) verdict.offending_t.push_back(vertices_of(star, k));
  } else if (!verdict.holds_in_t) {
    return verdict;
  }
  const bool both_on_z = star.vertices[0].value == 0 && star.vertices[1].value == 0;
  if (star.form != ZeroForm::embedded || !both_on_z) return verdict;
  const std::vector<StarFacet> facets = side_facets(star);
  if (std::none_of(facets.begin(), facets.end(), [](const StarFacet& f) { return f.ring(); })) {
    verdict.holds_in_zero_set = false;
    if (list_offenders) verdict.offending_zero.push_back({star.a(), star.b()});
    return verdict;
  }
  const std::vector<Key> in_zero_set = offenders_in_zero_set(facets);
  verdict.holds_in_zero_set = in_zero_set.empty();
  if (list_offenders) {
    for (const Key k : in_zero_set) verdict.offending_zero.push_back(vertices_of(star, k));
  }
  if (!verdict.holds_in_zero_set) return verdict;
  const std::vector<Key> on_curves = offenders_on_curves(star, facets);
  verdict.holds_on_curves = on_curves.empty();
  if (list_offenders) {
    for (const Key k : on_curves)
      verdict.offending_zero.push_back(k == 0 ? std::vector{star.a(), star.b()} : vertices_of(star, k));
  }
  return verdict;
}

} // namespace isoscope
