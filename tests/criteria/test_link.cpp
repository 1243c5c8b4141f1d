// The link condition: hand-made stars with one offender each, and the definition by sets over random edges.
#include "criteria/link.h"

#include "criteria/stars.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace isoscope;
using namespace isoscope::test;

namespace {

using Simplex = std::vector<VertexId>;
using Simplices = std::set<Simplex>;

VertexId id(std::size_t local) {
  return VertexId(100 + local);
}

/// All faces of the part of each tetrahedron at all of `ends` that is opposite to them.
Simplices link_of(const EdgeStar& star, const std::vector<std::uint16_t>& ends) {
  Simplices link;
  for (const EdgeStar::StarTet& t : star.tets) {
    Simplex rest;
    std::size_t found = 0;
    for (const std::uint16_t v : t.v) {
      if (std::find(ends.begin(), ends.end(), v) != ends.end()) {
        ++found;
      } else {
        rest.push_back(star.vertices[v].id);
      }
    }
    if (found != ends.size()) continue;
    for (std::size_t mask = 1; mask < std::size_t{1} << rest.size(); ++mask) {
      Simplex face;
      for (std::size_t i = 0; i < rest.size(); ++i) {
        if (mask >> i & 1) face.push_back(rest[i]);
      }
      std::sort(face.begin(), face.end());
      link.insert(face);
    }
  }
  return link;
}

Simplices offenders_by_definition(const EdgeStar& star) {
  const Simplices a = link_of(star, {0}), b = link_of(star, {1}), edge = link_of(star, {0, 1});
  Simplices offenders;
  for (const Simplex& s : a) {
    if (b.count(s) && !edge.count(s)) offenders.insert(s);
  }
  return offenders;
}

Simplices sorted(const std::vector<Simplex>& list) {
  Simplices result;
  for (Simplex s : list) {
    std::sort(s.begin(), s.end());
    result.insert(s);
  }
  return result;
}

/// The bipyramid of four with Z upright through x0 and x2.
EdgeStar upright_zero_set() {
  EdgeStar star = octahedron_star();
  embed(star, {1, 1, -1, -1, 1, 1, -1, -1, 1, 1, -1, -1}, {3, 5});
  return star;
}

} // namespace

TEST_CASE("rings of three and more in a bipyramid can be collapsed") {
  for (const std::size_t n : {3u, 4u, 5u, 9u}) {
    const LinkVerdict verdict = check_link(bipyramid_star(n), true);
    CHECK(verdict.holds());
    CHECK(verdict.offending_t.empty());
    CHECK(verdict.offending_zero.empty());
  }
}

TEST_CASE("a vertex joined to both ends but not to the edge, as on the right of Figure 6") {
  EdgeStar star = bipyramid_star(4);
  for (EdgeStar::StarTet& t : star.tets) std::replace(t.v.begin(), t.v.end(), 7, 6);
  const LinkVerdict verdict = check_link(star, true);
  CHECK_FALSE(verdict.holds_in_t);
  CHECK(sorted(verdict.offending_t).count({id(6)}) == 1);
  CHECK(sorted(verdict.offending_t) == offenders_by_definition(star));
  const LinkVerdict quick = check_link(star, false);
  CHECK_FALSE(quick.holds_in_t);
  CHECK(quick.offending_t.empty());
}

TEST_CASE("an edge across the ring that both ends see") {
  // a closes its side with two tetrahedra along the diagonal 2-4 of the ring; b with two tents over the
  // halves.
  const std::vector<Vec3> p{{0, 0, 0.3}, {0, 0, -0.3}, {1, 0, 0},      {0, 1, 0},
                            {-1, 0, 0},  {0, -1, 0},   {0.3, 0.3, -2}, {-0.3, -0.3, -2}};
  const EdgeStar star = make_star(p, {{0, 1, 2, 3},
                                      {0, 1, 3, 4},
                                      {0, 1, 4, 5},
                                      {0, 1, 5, 2},
                                      {0, 2, 3, 4},
                                      {0, 2, 4, 5},
                                      {1, 2, 3, 6},
                                      {1, 3, 4, 6},
                                      {1, 4, 2, 6},
                                      {1, 4, 5, 7},
                                      {1, 5, 2, 7},
                                      {1, 2, 4, 7}});
  const LinkVerdict verdict = check_link(star, true);
  CHECK_FALSE(verdict.holds_in_t);
  CHECK(sorted(verdict.offending_t) == Simplices{{id(2), id(4)}});
  CHECK_FALSE(check_link(star, false).holds_in_t);
}

TEST_CASE("a triangle that fills the ring of three on both sides") {
  // The boundary of a simplex of four dimensions, but for its facet without the edge.
  const std::vector<Vec3> p{{0, 0, 0.3}, {0, 0, -0.3}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  const EdgeStar star = make_star(p, {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 2}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  const LinkVerdict verdict = check_link(star, true);
  CHECK(sorted(verdict.offending_t) == Simplices{{id(2), id(3), id(4)}});
  CHECK_FALSE(check_link(star, false).holds_in_t);
}

TEST_CASE("the definition agrees over random Delaunay edges") {
  std::size_t collapsible = 0, refused = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const EdgeStar& star : random_stars(60, 3, seed)) {
      const Simplices expected = offenders_by_definition(star);
      const LinkVerdict verdict = check_link(star, true);
      CHECK(sorted(verdict.offending_t) == expected);
      CHECK(verdict.holds_in_t == expected.empty());
      CHECK(check_link(star, false).holds_in_t == expected.empty());
      ++(expected.empty() ? collapsible : refused);
    }
  }
  CHECK(collapsible > 50);
  CHECK(refused > 50);
}

TEST_CASE("an edge of Z with two common neighbours on it") {
  const EdgeStar star = upright_zero_set();
  REQUIRE(star.kind() == EdgeKind::zero);
  CHECK(zero_facets(star).size() == 6);
  CHECK(check_link(star, true).holds());
  CHECK(check_link(star, false).holds());
}

TEST_CASE("a third common neighbour on Z") {
  // A pocket beside x1 at each end: a-x1 and b-x1 are edges of Z, a-b-x1 is no facet of it.
  EdgeStar star = octahedron_star();
  embed(star, {1, 1, -1, -1, -1, 1, -1, -1, -1, 1, -1, -1}, {5});
  REQUIRE(star.kind() == EdgeKind::zero);
  const LinkVerdict verdict = check_link(star, true);
  CHECK(verdict.holds_in_t);
  CHECK_FALSE(verdict.holds_in_zero_set);
  CHECK(sorted(verdict.offending_zero).count({id(3)}) == 1);
  CHECK_FALSE(check_link(star, false).holds_in_zero_set);
}

TEST_CASE("Z the boundary of one tetrahedron cannot lose an edge") {
  EdgeStar star = bipyramid_star(3);
  embed(star, {1, -1, -1, -1, -1, -1, -1, -1, -1}, {4, 5, 6});
  REQUIRE(star.kind() == EdgeKind::zero);
  const LinkVerdict verdict = check_link(star, true);
  CHECK(verdict.holds_in_t);
  CHECK_FALSE(verdict.holds_in_zero_set);
  CHECK(sorted(verdict.offending_zero) == Simplices{{id(2), id(3)}});
}

TEST_CASE("two vertices of Z that no edge of Z joins are not identified") {
  EdgeStar star = octahedron_star();
  embed(star, {1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1}, {});
  const LinkVerdict verdict = check_link(star, true);
  CHECK(verdict.holds_in_t);
  CHECK_FALSE(verdict.holds_in_zero_set);
  CHECK(sorted(verdict.offending_zero) == Simplices{{id(0), id(1)}});
}

TEST_CASE("Z is not asked for where an end is off it, nor before it is embedded") {
  EdgeStar mixed = octahedron_star();
  embed(mixed, {1, 1, 1, 1, 1, 1, -1, -1, 1, 1, 1, 1}, {1, 7});
  REQUIRE(mixed.kind() == EdgeKind::mixed);
  CHECK(check_link(mixed, true).holds());
  CHECK(check_link(octahedron_star(), true).holds_in_zero_set);
}
