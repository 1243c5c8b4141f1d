// The star that queues ask for against the whole one.
#include "mesh/cost_star.h"

#include "mesh/strata.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using namespace isoscope::test;

namespace {

struct Found {
  std::size_t edges = 0, of_a_kind = 0;
};

/// Compares both stars of each edge of T.
Found compare(const Complex& c, CostRing ring) {
  const Incidence incidence(c);
  Found found;
  for (const Tet& t : c.tets) {
    if (!t.alive()) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        const EdgeStar whole = gather_edge_star(c, incidence, t.v[i], t.v[j], ring);
        const EdgeStar cost = gather_cost_star(c, incidence, t.v[i], t.v[j], ring);
        REQUIRE(cost.kind() == whole.kind());
        REQUIRE(strata_of(cost).pinned() == strata_of(whole).pinned());
        ++found.edges;
        if (whole.kind() == EdgeKind::other) continue;
        ++found.of_a_kind;
        REQUIRE(cost.a() == whole.a());
        REQUIRE(cost.b() == whole.b());
        REQUIRE(cost.cost_facets == whole.cost_facets);
        REQUIRE(cost.cost_borders == whole.cost_borders);
      }
    }
  }
  return found;
}

/// A triangulation with F = -1 in a ball and +1 outside.
Complex two_sides() {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  Complex c;
  for (const Delta& d : grow(unit, random_points(300, {{0.05, 0.05, 0.05}, {0.95, 0.95, 0.95}}, 2)).deltas)
    c.apply(d);
  for (Vertex& v : c.vertices) {
    if (v.kind == VertexKind::box) continue;
    v.value = distance(v.position, {0.5, 0.5, 0.5}) < 0.3 ? -1 : 1;
  }
  return c;
}

/// The same with sides of tetrahedra, by where their middles are; vertices between two sides are on Z.
Complex embedded(int sides) {
  Complex c = two_sides();
  c.form = ZeroForm::embedded;
  for (std::size_t t = 0; t < c.tets.size(); ++t) {
    if (!c.tets[t].alive()) continue;
    const auto p = c.positions(TetId(t));
    const Vec3 middle = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    const bool in = distance(middle, {0.5, 0.5, 0.5}) < 0.3;
    c.tets[t].side = static_cast<std::int8_t>(!in ? 1 : sides == 3 && middle.x > 0.5 ? -2 : -1);
  }
  std::vector<int> first(c.vertices.size(), 0);
  for (const Tet& t : c.tets) {
    if (!t.alive()) continue;
    for (const VertexId v : t.v) {
      int& side = first[v.index()];
      if (side != 0 && side != t.side) c.vertices[v.index()].value = 0;
      side = t.side;
    }
  }
  return c;
}

} // namespace

TEST_CASE("the star of an edge's error has the kind, strata and facets of the whole one") {
  for (const CostRing ring : {CostRing::one, CostRing::two}) {
    for (const Complex& c : {two_sides(), embedded(2), embedded(3)}) {
      const Found found = compare(c, ring);
      CHECK(found.edges > 5000);
      CHECK(found.of_a_kind > 100);
    }
  }
}
