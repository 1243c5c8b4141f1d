// Strata of links that are known by heart, and of states made by hand.
#include "mesh/strata.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

constexpr FacetKind kept{-1, 1, false}, dropped{-1, 1, true};
using Nodes = std::vector<std::uint32_t>;

/// A cycle of n arcs from node 0, the first `of_z` of Z.
std::vector<LinkArc> cycle(std::uint32_t n, std::uint32_t of_z) {
  std::vector<LinkArc> arcs;
  for (std::uint32_t i = 0; i < n; ++i) arcs.push_back({i, (i + 1) % n, i < of_z ? kept : dropped});
  return arcs;
}

VertexId vertex_at(const Complex& c, Vec3 p) {
  for (std::size_t v = 0; v < c.vertices.size(); ++v)
    if (c.vertices[v].position == p) return VertexId(v);
  return {};
}

} // namespace

TEST_CASE("links of sheets, curves and points") {
  CHECK(stratum_of(std::vector<LinkArc>{}) == Stratum::room);
  CHECK(stratum_of(cycle(6, 6)) == Stratum::sheet);
  CHECK(stratum_of(cycle(6, 0)) == Stratum::sheet);
  CHECK(stratum_of(cycle(6, 2)) == Stratum::curve);
  CHECK(curves_from(cycle(6, 2)) == Nodes{0, 2});
  CHECK(borders_from(cycle(6, 2)) == Nodes{0, 2});
  CHECK(borders_from(cycle(6, 6)).empty());
  // Two fans of Z meet in one vertex.
  std::vector<LinkArc> bow_tie = cycle(6, 1);
  bow_tie[3].kind = kept;
  CHECK(stratum_of(bow_tie) == Stratum::point);
  CHECK(borders_from(bow_tie) == Nodes{0, 1, 3, 4});
  // Two sheets that touch: two cycles.
  std::vector<LinkArc> touching = cycle(3, 3);
  for (const LinkArc& arc : cycle(3, 3)) touching.push_back({arc.from + 10, arc.to + 10, arc.kind});
  CHECK(stratum_of(touching) == Stratum::point);
  // A triple curve: three sheets between two nodes; with a fourth circle beside it no longer.
  std::vector<LinkArc> book{
      {0, 1, {-1, 1}}, {1, 9, {-1, 1}}, {0, 2, {-2, 1}}, {2, 9, {-2, 1}}, {0, 9, {-2, -1}}};
  CHECK(stratum_of(book) == Stratum::curve);
  CHECK(curves_from(book) == Nodes{0, 9});
  CHECK(borders_from(book).empty());
  for (const LinkArc& arc : cycle(3, 3)) book.push_back({arc.from + 20, arc.to + 20, arc.kind});
  CHECK(stratum_of(book) == Stratum::point);
  // Four rooms meet: the edges of a tetrahedron.
  std::vector<LinkArc> four;
  for (std::uint32_t i = 0; i < 4; ++i)
    for (std::uint32_t j = i + 1; j < 4; ++j)
      four.push_back({i, j, {static_cast<std::int8_t>(i), static_cast<std::int8_t>(j + 1)}});
  CHECK(stratum_of(four) == Stratum::point);
  CHECK(curves_from(four) == Nodes{0, 1, 2, 3});
  // Two sheets of one pair of labels with another pair between: a seam counts as a curve.
  CHECK(stratum_of(std::vector<LinkArc>{{0, 1, {-1, 1}}, {1, 2, {-2, 1}}, {2, 0, {-2, 1}}}) ==
        Stratum::curve);
}

TEST_CASE(
    "a plane with a round patch of Z has one border, and two half-spaces under a third a triple curve") {
  const Complex patch = test::lattice_with_sides(
      7, [](Vec3 p) { return p.z < 3 ? -1 : 1; },
      [](Vec3 p) {
        return distance(p, Vec3{3, 3, 3}) > 1.9;
      });
  const Incidence incidence(patch);
  CHECK(stratum_of(patch, incidence, vertex_at(patch, {3, 3, 3})) == Stratum::sheet);
  CHECK(on_zero_set(patch, incidence, vertex_at(patch, {3, 3, 3})));
  CHECK(stratum_of(patch, incidence, vertex_at(patch, {5, 5, 3})) == Stratum::sheet);
  CHECK_FALSE(on_zero_set(patch, incidence, vertex_at(patch, {5, 5, 3})));
  CHECK(stratum_of(patch, incidence, vertex_at(patch, {3, 3, 1})) == Stratum::room);
  std::size_t on_border = 0, ends = 0;
  for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
    const std::size_t borders = borders_from(link_arcs(patch, incidence, VertexId(v))).size();
    if (borders == 0) continue;
    CHECK(stratum_of(patch, incidence, VertexId(v)) == Stratum::curve);
    ++on_border;
    ends += borders;
  }
  CHECK(on_border >= 8);
  CHECK(ends == 2 * on_border);

  const Complex rooms = test::lattice_with_sides(
      5, [](Vec3 p) { return p.z > 2 ? 1 : (p.x < 2 ? -1 : -2); }, [](Vec3) { return false; });
  const Incidence at(rooms);
  CHECK(stratum_of(rooms, at, vertex_at(rooms, {2, 2, 2})) == Stratum::curve);
  CHECK(stratum_of(rooms, at, vertex_at(rooms, {1, 2, 2})) == Stratum::sheet);
  CHECK(stratum_of(rooms, at, vertex_at(rooms, {2, 2, 1})) == Stratum::sheet);
  CHECK(stratum_of(rooms, at, vertex_at(rooms, {1, 1, 1})) == Stratum::room);
  const auto [stays, goes] =
      oriented_edge(rooms, at, vertex_at(rooms, {1, 2, 2}), vertex_at(rooms, {2, 2, 2}));
  CHECK(stays == vertex_at(rooms, {2, 2, 2}));
  CHECK(goes == vertex_at(rooms, {1, 2, 2}));
}
