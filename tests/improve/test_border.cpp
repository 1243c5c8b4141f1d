// Borders: connectivity, placement, and whole runs whose border keeps to the rim.
#include "base/parallel.h"
#include "improve/patch_moves.h"
#include "improve/support.h"
#include "tolerance/border_gate.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

FacetComplex bordered_complex_of(const TriangleMesh& mesh) {
  FacetComplex complex;
  complex.points = mesh.points;
  for (const auto& t : mesh.triangles) complex.facets.emplace_back().v = t;
  complex.build_stars();
  complex.build_border();
  return complex;
}

/// Facets of a mesh whose centroid lies where `kept` says so.
template <class Kept> TriangleMesh part_of(const TriangleMesh& mesh, const Kept& kept) {
  TriangleMesh part;
  std::vector<std::uint32_t> number(mesh.points.size(), Facet::none);
  for (const auto& t : mesh.triangles) {
    if (!kept(centroid({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}))) continue;
    std::array<std::uint32_t, 3> f{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& n = number[t[k]];
      if (n == Facet::none)
        n = static_cast<std::uint32_t>(part.points.size()), part.points.push_back(mesh.points[t[k]]);
      f[k] = n;
    }
    part.triangles.push_back(f);
  }
  return part;
}

std::vector<Segment3> border_of(const TriangleMesh& mesh) {
  const FacetComplex complex = bordered_complex_of(mesh);
  std::vector<Segment3> edges;
  for (std::uint32_t v = 0; v < complex.border.size(); ++v)
    if (complex.on_border(v)) edges.push_back({complex.points[v], complex.points[complex.border[v].next]});
  return edges;
}

std::size_t loops(const FacetComplex& complex) {
  std::vector<std::uint8_t> seen(complex.points.size(), 0);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < complex.border.size(); ++v) {
    if (!complex.on_border(v) || seen[v]) continue;
    ++count;
    for (std::uint32_t w = v; !seen[w]; w = complex.border[w].next) seen[w] = 1;
  }
  return count;
}

long euler_characteristic(const FacetComplex& complex) {
  long vertices = 0, facets = 0;
  for (std::uint32_t v = 0; v < complex.points.size(); ++v) vertices += complex.alive_vertex(v) ? 1 : 0;
  for (const Facet& f : complex.facets) facets += f.alive() ? 1 : 0;
  return vertices - static_cast<long>(complex.edges().size()) + facets;
}

/// Each edge once or twice, in opposite directions; where once it is the border's, which passes each vertex
/// once.
void check_manifold(const FacetComplex& complex) {
  std::vector<int> arrives(complex.points.size(), 0);
  for (std::uint32_t f = 0; f < complex.facets.size(); ++f) {
    if (!complex.facets[f].alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = complex.facets[f].v[k], to = complex.facets[f].v[(k + 1) % 3];
      CHECK(complex.facet_left_of(from, to) == f);
      const bool alone = complex.facet_left_of(to, from) == Facet::none;
      CHECK(alone == (!complex.border.empty() && complex.border[from].next == to));
      if (alone) ++arrives[to];
    }
  }
  for (std::uint32_t v = 0; v < complex.border.size(); ++v) {
    CHECK(arrives[v] == (complex.on_border(v) ? 1 : 0));
    if (!complex.alive_vertex(v)) continue;
    const auto star = complex.star(v);
    CHECK(star.size() == complex.stars[v].size());
    for (std::size_t i = 0; i + 1 < star.size(); ++i) CHECK(star[i].next == star[i + 1].rim);
    if (!complex.on_border(v)) continue;
    CHECK(star.front().rim == complex.border[v].next);
    CHECK(star.back().next == complex.border_before(v));
  }
}

/// The upper half of a sphere over the whole sphere's Ω, its border held to its own rim.
struct HalfSphere {
  Start start;
  TriangleMesh mesh;
  std::vector<Segment3> rim;

  HalfSphere(unsigned n, double percent, double from = 0.02, double below = 2)
      : start(sphere(n), percent),
        mesh(part_of(start.mesh, [&](Vec3 c) { return c.z > from && c.z < below; })), rim(border_of(mesh)) {
    start.volume->keep_border_to(rim);
  }
};

void check_result(const TriangleMesh& mesh, const HalfSphere& half, long characteristic,
                  std::size_t loop_count) {
  const FacetComplex complex = bordered_complex_of(mesh);
  check_manifold(complex);
  CHECK(euler_characteristic(complex) == characteristic);
  CHECK(loops(complex) == loop_count);
  const double delta = half.start.delta();
  for (const auto& t : mesh.triangles) {
    const Triangle3 facet{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    CHECK(certify_facet(half.start.volume->field(), facet, delta, delta).kind == FacetVerdict::Kind::inside);
  }
  const std::vector<Segment3> border = border_of(mesh);
  const BorderGate to_rim(half.rim, delta), to_border(border, delta);
  for (const Segment3& edge : border) CHECK(to_rim.keeps_to_rim(edge).proven);
  for (const Segment3& edge : half.rim) CHECK(to_border.keeps_to_rim(edge).proven);
}

} // namespace

TEST_CASE("a disc collapses to one triangle, an annulus to two loops of three") {
  const Start whole(sphere(12), 5);
  for (const bool annulus : {false, true}) {
    FacetComplex complex = bordered_complex_of(
        part_of(whole.mesh, [&](Vec3 c) { return c.z > 0.02 && (!annulus || c.z < 0.8); }));
    const std::size_t loop_count = annulus ? 2 : 1;
    check_manifold(complex);
    REQUIRE(loops(complex) == loop_count);
    REQUIRE(euler_characteristic(complex) == (annulus ? 0 : 1));
    Random random(4);
    std::size_t kinds[2] = {0, 0};
    for (int i = 0; i < 20000; ++i) {
      const auto& facet = complex.facets[random.below(complex.facets.size())];
      if (!facet.alive()) continue;
      const std::size_t k = random.below(3);
      std::uint32_t a = facet.v[k], b = facet.v[(k + 1) % 3];
      if (random.below(2) == 0) std::swap(a, b);
      if (!complex.link_condition(a, b)) continue;
      ++kinds[complex.has_border_edge(a, b) ? 1 : 0];
      complex.collapse(a, b);
      if (i % 50 == 0) check_manifold(complex);
    }
    check_manifold(complex);
    CHECK(kinds[0] > 10);
    CHECK(kinds[1] > 5);
    CHECK(loops(complex) == loop_count);
    CHECK(euler_characteristic(complex) == (annulus ? 0 : 1));
    const auto alive =
        std::count_if(complex.facets.begin(), complex.facets.end(), [](const Facet& f) { return f.alive(); });
    CHECK(alive == (annulus ? 6 : 1));
  }
}

TEST_CASE("an inner edge between two borders is no edge to collapse, nor is a loop of three") {
  // A strip of four triangles: its ends are loops of none, its middle edges join the border with itself.
  TriangleMesh strip;
  strip.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
  strip.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
  const FacetComplex complex = bordered_complex_of(strip);
  check_manifold(complex);
  CHECK(complex.edges().size() == 9);
  CHECK_FALSE(complex.link_condition(0, 3));
  CHECK_FALSE(complex.link_condition(2, 3));
  CHECK(complex.link_condition(0, 1));
  CHECK(complex.link_condition(1, 3));
  TriangleMesh one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  CHECK_FALSE(bordered_complex_of(one).link_condition(0, 1));
}

TEST_CASE("a merged vertex of the border is placed near the rim, one inside goes to it") {
  const HalfSphere half(24, 4);
  const InputSurface input(half.start.volume->field(), half.start.delta(), half.mesh, {},
                           half.start.volume->border_gate());
  SurfaceRules rules;
  rules.input = &input;
  const LiveSurface surface(half.mesh, rules);
  const FacetComplex& complex = surface.complex();
  std::size_t along = 0, inward = 0;
  for (const auto& [a, b] : complex.edges()) {
    const bool at_a = complex.on_border(a), at_b = complex.on_border(b);
    if (!at_a && !at_b) continue;
    const auto candidate = collapse_candidate(input, complex, a, b, {});
    if (!candidate) continue;
    if (at_a && at_b) {
      CHECK(half.start.volume->border_gate()->rim().closest(candidate->target).distance < half.start.delta());
      ++along;
    } else {
      CHECK(candidate->target == complex.points[at_a ? a : b]);
      ++inward;
    }
  }
  CHECK(along > 10);
  CHECK(inward > 10);
}

TEST_CASE("a half sphere and a zone get coarse, and their borders and rims stay within δ of each other") {
  for (const double below : {2., 0.7}) {
    CAPTURE(below);
    const HalfSphere half(24, 2, 0.02, below);
    const bool zone = below < 1;
    std::size_t last = half.mesh.points.size();
    for (int effort = 0; effort <= 2; ++effort) {
      TriangleMesh mesh = half.mesh;
      Listener listener;
      const auto outcome =
          improve(mesh, *half.start.volume, nullptr, with_effort(effort), RunControl(), listener);
      CHECK(outcome.end == ImproverOutcome::End::finished);
      check_result(mesh, half, zone ? 0 : 1, zone ? 2 : 1);
      CHECK(mesh.points.size() <= last);
      last = mesh.points.size();
      MESSAGE("vertices " << half.mesh.points.size() << " -> " << mesh.points.size() << " border "
                          << border_of(mesh).size() << " of " << half.rim.size());
      const std::size_t border = border_of(mesh).size();
      CHECK(border * 3 < half.rim.size());
    }
    CHECK(last <= 40);
  }
}

TEST_CASE("with a border one thread and several give the same bits, and a stop leaves it valid") {
  const HalfSphere half(24, 3);
  TriangleMesh expected;
  for (const unsigned threads : {1u, 2u, 5u}) {
    const ThreadLimit limit(threads);
    TriangleMesh mesh = half.mesh;
    Listener listener;
    improve(mesh, *half.start.volume, nullptr, with_effort(1), RunControl(), listener);
    if (expected.points.empty()) expected = mesh;
    CHECK(mesh.points == expected.points);
    CHECK(mesh.triangles == expected.triangles);
  }
  for (const std::size_t after : {1u, 20u, 60u}) {
    TriangleMesh mesh = half.mesh;
    Listener listener;
    listener.stop_after = after;
    improve(mesh, *half.start.volume, nullptr, with_effort(2), RunControl(), listener);
    check_result(mesh, half, 1, 1);
  }
}
