// Link conditions on strata: chains of collapses that they allow keep every stratum what it is.
#include "criteria/link.h"
#include "mesh/strata.h"
#include "mesh/support.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

using namespace isoscope;

namespace {

using Edge = std::pair<VertexId, VertexId>;

/// What is to be kept: of each kind of sheet χ and its components, the components and χ of the curves,
/// points.
struct Arrangement {
  std::map<std::tuple<int, int, bool>, std::pair<long, long>> sheets;
  long curve_components = 0, curve_characteristic = 0;
  std::set<std::uint32_t> points;
  friend bool operator==(const Arrangement&, const Arrangement&) = default;
};

long components(const std::set<Edge>& edges) {
  std::map<VertexId, VertexId> root;
  const auto find = [&](VertexId v) {
    while (root.contains(v) && root[v] != v) v = root[v];
    return v;
  };
  for (const auto& [a, b] : edges) root.try_emplace(a, a), root.try_emplace(b, b), root[find(a)] = find(b);
  return std::count_if(root.begin(), root.end(), [](const auto& r) { return r.first == r.second; });
}

Arrangement arrangement(const Complex& c) {
  const Incidence incidence(c);
  std::map<std::tuple<int, int, bool>, std::set<std::array<std::uint32_t, 3>>> facets;
  std::map<std::tuple<int, int, bool>, std::set<Edge>> edges;
  std::map<std::tuple<int, int, bool>, std::set<VertexId>> vertices;
  Arrangement found;
  std::set<Edge> curves;
  std::set<VertexId> on_curves;
  for (std::size_t i = 0; i < c.vertices.size(); ++i) {
    const VertexId v(i);
    if (!c.vertices[i].alive) continue;
    const std::vector<LinkArc> link = link_arcs(c, incidence, v);
    if (stratum_of(link) == Stratum::point) found.points.insert(v.value);
    for (const std::uint32_t w : curves_from(link)) {
      curves.insert(std::minmax(v, VertexId(w)));
      on_curves.insert(v);
    }
    for (const LinkArc& arc : link) {
      const std::tuple kind(arc.kind.low, arc.kind.high, arc.kind.dropped);
      std::array<std::uint32_t, 3> f{v.value, arc.from, arc.to};
      std::sort(f.begin(), f.end());
      facets[kind].insert(f);
      for (const std::uint32_t w : {arc.from, arc.to}) edges[kind].insert(std::minmax(v, VertexId(w)));
      vertices[kind].insert(v);
    }
  }
  for (const auto& [kind, f] : facets)
    found.sheets[kind] = {static_cast<long>(vertices[kind].size()) - static_cast<long>(edges[kind].size()) +
                              static_cast<long>(f.size()),
                          components(edges[kind])};
  found.curve_components = components(curves);
  found.curve_characteristic = static_cast<long>(on_curves.size()) - static_cast<long>(curves.size());
  return found;
}

bool is_dropped(const Tet& t, std::size_t k) {
  return (t.dropped >> k & 1u) != 0;
}

/// Where a tetrahedron has another one beside it.
std::size_t place_of(const Tet& t, TetId neighbor) {
  std::size_t k = 0;
  while (k < 3 && t.neighbor[k] != neighbor) ++k;
  return k;
}

/// Both tetrahedra of a facet say the same of it, and nothing is dropped between equal sides.
bool bits_agree(const Complex& c) {
  for (std::size_t i = 0; i < c.tets.size(); ++i) {
    const Tet& t = c.tets[i];
    if (!t.alive()) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!t.neighbor[k].valid()) continue;
      const Tet& other = c.tet(t.neighbor[k]);
      if (is_dropped(t, k) != is_dropped(other, place_of(other, TetId(i)))) return false;
      if (is_dropped(t, k) && t.side == other.side) return false;
    }
  }
  return true;
}

struct Chain {
  std::size_t collapsed = 0, on_sheets = 0, on_curves = 0, refused = 0;
};

/// Collapses edges in a random order to the end that stays, wherever the conditions allow it, as if T had
/// room.
Chain collapse_what_may_be(Complex& c, std::uint64_t seed) {
  Chain chain;
  test::Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const Tet& t = c.tets[random.below(c.tets.size())];
    if (!t.alive()) continue;
    const VertexId v = t.v[random.below(4)], w = t.v[random.below(4)];
    const auto is_box = [&](VertexId x) { return c.vertices[x.index()].kind == VertexKind::box; };
    if (v == w || is_box(v) || is_box(w)) continue;
    const Incidence incidence(c);
    const auto [a, b] = oriented_edge(c, incidence, v, w);
    const EdgeStar star = gather_edge_star(c, incidence, a, b, CostRing::one);
    const EdgeStrata strata = strata_of(star);
    const LinkVerdict verdict = check_link(star, true);
    CHECK(check_link(star, false).holds() == verdict.holds());
    CHECK(verdict.holds_in_strata() == (verdict.offending_zero.empty()));
    CHECK(strata.a <= strata.b);
    if (!verdict.holds()) {
      ++chain.refused;
      continue;
    }
    const Delta delta = collapse_delta(c, incidence, a, b, c.position(a));
    Complex after = c;
    after.apply(delta);
    Complex back = after;
    back.undo(delta);
    CHECK(back == c);
    c = std::move(after);
    ++chain.collapsed;
    chain.on_sheets += strata.edge == Stratum::sheet;
    chain.on_curves += strata.edge == Stratum::curve;
  }
  return chain;
}

void check_kept(Complex c) {
  const Arrangement before = arrangement(c);
  REQUIRE(bits_agree(c));
  const Chain chain = collapse_what_may_be(c, 11);
  CHECK(chain.collapsed > 60);
  CHECK(chain.on_sheets > 10);
  CHECK(chain.on_curves > 3);
  CHECK(chain.refused > 60);
  CHECK(bits_agree(c));
  const Arrangement after = arrangement(c);
  CHECK(after.sheets == before.sheets);
  CHECK(after.curve_components == before.curve_components);
  CHECK(after.curve_characteristic == before.curve_characteristic);
  CHECK(after.points == before.points);
}

} // namespace

TEST_CASE("a round patch, an annulus and a slit sphere stay what they are") {
  const auto plane = [](Vec3 p) { return p.z < 3 ? -1 : 1; };
  const Vec3 middle{3, 3, 3};
  check_kept(test::lattice_with_sides(7, plane, [&](Vec3 p) { return distance(p, middle) > 2.4; }));
  check_kept(test::lattice_with_sides(
      7, plane, [&](Vec3 p) { return distance(p, middle) > 2.4 || distance(p, middle) < 1; }));
  const auto ball = [&](Vec3 p) { return distance(p, middle) < 2.3 ? -1 : 1; };
  check_kept(test::lattice_with_sides(7, ball, [](Vec3 p) { return p.z > 3.4; }));
}

TEST_CASE("rooms that share walls keep their sheets, curves and points") {
  const Vec3 middle{3, 3, 3};
  const auto none = [](Vec3) { return false; };
  const auto in_box = [](Vec3 p) { return p.x > 1 && p.y > 1 && p.z > 1 && p.x < 5 && p.y < 5 && p.z < 5; };
  check_kept(test::lattice_with_sides(
      7, [&](Vec3 p) { return !in_box(p) ? 1 : (p.x < 3 ? -1 : -2); }, none));
  check_kept(test::lattice_with_sides(
      7, [&](Vec3 p) { return !in_box(p) ? 1 : (p.x < 3 ? -1 : (p.y < 3 ? -2 : -3)); }, none));
  // Four rooms about an edge, of which one wall is taken out: borders end on triple curves.
  check_kept(test::lattice_with_sides(
      7, [&](Vec3 p) { return !in_box(p) ? 1 : (p.x < 3 ? -1 : -2); },
      [&](Vec3 p) { return p.x == 3 && distance(p, middle) < 1; }));
}
