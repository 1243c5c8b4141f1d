// Flips of T on hand-made stars: what they replace, what they refuse, and that a patch comes back as a delta.
#include "collapse/tet_flips.h"

#include "mesh/incidence.h"
#include "mesh/predicates.h"
#include "mesh/validity.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace isoscope;

namespace {

/// An edge from vertex 0 (below) to vertex 1 (above) with a ring of n vertices around it at the given
/// heights.
Complex star_of_edge(const std::vector<double>& heights) {
  Complex c;
  const auto add = [&](Vec3 p) {
    Vertex v;
    v.position = p;
    v.value = 0;
    v.kind = VertexKind::zero;
    c.vertices.push_back(v);
  };
  add({0, 0, -1});
  add({0, 0, 1});
  const std::size_t n = heights.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    add({std::cos(angle), std::sin(angle), heights[i]});
  }
  Delta delta;
  for (std::size_t i = 0; i < n; ++i)
    delta.added.push_back(
        {TetId(i), canonical_order({VertexId(0), VertexId(1), VertexId(2 + i), VertexId(2 + (i + 1) % n)}),
         1});
  c.form = ZeroForm::embedded;
  c.apply(delta);
  return c;
}

TetPatch whole(const Complex& c) {
  std::vector<TetId> tets;
  for (std::size_t t = 0; t < c.tets.size(); ++t)
    if (c.tets[t].alive()) tets.emplace_back(t);
  return {c, tets};
}

double volume(const Complex& c) {
  double sum = 0;
  for (std::size_t t = 0; t < c.tets.size(); ++t) {
    if (!c.tets[t].alive()) continue;
    const auto p = c.positions(TetId(t));
    sum += dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) / 6;
  }
  return sum;
}

/// Applies the patch, checks what came out, and undoes it.
std::size_t tets_after(const Complex& before, const TetPatch& patch) {
  Complex c = before;
  const Delta delta = patch.delta(c.tets.size());
  c.apply(delta);
  CHECK(check_complex(c).empty());
  CHECK(std::abs(volume(c)) == doctest::Approx(std::abs(volume(before))));
  const std::size_t count = c.alive_tets();
  c.undo(delta);
  CHECK(c == before);
  return count;
}

} // namespace

TEST_CASE("an edge gives way to a triangulation of its ring") {
  for (std::size_t n = 3; n <= 8; ++n) {
    CAPTURE(n);
    const Complex c = star_of_edge(std::vector<double>(n, 0));
    REQUIRE(check_complex(c).empty());
    TetPatch patch = whole(c);
    CHECK(patch.up_to_date(c));
    REQUIRE(remove_edge(patch, 0, 1));
    CHECK(tets_after(c, patch) == 2 * (n - 2));
    CHECK_FALSE(remove_edge(patch, 0, 1)); // it is gone
  }
  const Complex many = star_of_edge(std::vector<double>(9, 0));
  TetPatch patch = whole(many);
  CHECK_FALSE(remove_edge(patch, 0, 1));
}

TEST_CASE("an edge stays where the ring cannot be filled, on Z and on the hull") {
  // One corner of the ring above the upper end: no triangle of a ring of three leaves both ends on their
  // sides.
  const Complex bent = star_of_edge({0, 0, 7});
  REQUIRE(check_complex(bent).empty());
  TetPatch patch = whole(bent);
  CHECK_FALSE(remove_edge(patch, 0, 1));
  CHECK(tets_after(bent, patch) == 3);

  Complex divided = star_of_edge({0, 0, 0, 0});
  divided.tets[0].side = -1;
  TetPatch on_z = whole(divided);
  CHECK_FALSE(remove_edge(on_z, 0, 1));
  const Complex c = star_of_edge({0, 0, 0, 0});
  TetPatch hull = whole(c);
  CHECK_FALSE(remove_edge(hull, 0, 2));
}

TEST_CASE("removing a triangle undoes the removal of an edge of three") {
  const Complex c = star_of_edge({0, 0, 0});
  TetPatch patch = whole(c);
  REQUIRE(remove_edge(patch, 0, 1));
  Complex two = c;
  two.apply(patch.delta(c.tets.size()));
  CHECK(two.alive_tets() == 2);
  TetPatch back = whole(two);
  CHECK_FALSE(remove_triangle(back, {0, 2, 3})); // on the hull
  REQUIRE(remove_triangle(back, {2, 3, 4}));
  CHECK(tets_after(two, back) == 3);
  two.tets[whole(two).tets_at(0)[0]].side = -1;
  TetPatch divided = whole(two);
  CHECK_FALSE(remove_triangle(divided, {2, 3, 4}));
}

TEST_CASE("a patch knows the kernel of its vertices and what has changed beneath it") {
  Complex c = star_of_edge({0, 0, 0, 0});
  // A second layer closes the star of vertex 1: the apex above it.
  Delta delta;
  Vertex apex;
  apex.position = {0, 0, 3};
  delta.added_vertices.push_back(apex);
  delta.slots_before = static_cast<std::uint32_t>(c.tets.size());
  for (std::size_t i = 0; i < 4; ++i)
    delta.added.push_back(
        {TetId(4 + i),
         canonical_order({VertexId(1), VertexId(6), VertexId(2 + i), VertexId(2 + (i + 1) % 4)}), 1});
  c.apply(delta);
  REQUIRE(check_complex(c).empty());
  TetPatch patch = whole(c);
  const Kernel kernel = patch.kernel(VertexId(1));
  CHECK(kernel.facets.size() == 8);
  CHECK(kernel.contains({0, 0, 1}));
  CHECK(kernel.contains({0.1, 0.2, 2}));
  CHECK_FALSE(kernel.contains({0, 0, 3.1}));
  CHECK_FALSE(kernel.contains({0.9, 0.9, 0.1}));
  patch.move(VertexId(1), {0.1, 0.2, 2});
  CHECK(tets_after(c, patch) == 8);
  CHECK(patch.up_to_date(c));
  c.apply(patch.delta(c.tets.size()));
  CHECK_FALSE(patch.up_to_date(c));
  CHECK(check_complex(c).empty());
}

TEST_CASE("a tetrahedron that changes sides takes the facets of Z along, seen from both sides") {
  Complex c = star_of_edge({0, 0, 0, 0});
  c.tets[0].side = -1;
  TetPatch patch = whole(c);
  const Tet& tet = c.tets[0];
  const auto found = patch.tet_between({tet.v[3], tet.v[1], tet.v[0], tet.v[2]});
  REQUIRE(found.has_value());
  CHECK_FALSE(patch.tet_between({VertexId(0), VertexId(1), VertexId(2), VertexId(4)}).has_value());
  patch.change_side(*found);
  const Delta delta = patch.delta(c.tets.size());
  CHECK(delta.removed.size() == 3); // it and the two next to it, not the one across the edge
  Complex after = c;
  after.apply(delta);
  CHECK(after.tets[0].side == 1);
  CHECK(difference(c, after).removed == delta.removed);
  CHECK(difference(c, after).added == delta.added);
  after.undo(delta);
  CHECK(after == c);
}
