// Flips against the energy: what is committed is valid and proven, the flipped edge is gone, threads do not
// matter.
#include "base/parallel.h"
#include "improve/patch_claims.h"
#include "improve/shake_round.h"
#include "improve/support.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using isoscope::testing::Bench;
using isoscope::testing::check_valid;

namespace {

constexpr int sweeps = 6;

} // namespace

TEST_CASE("a pass flips edges of a sphere, keeps its vertices and all that holds of it") {
  const Bench bench(testing::sphere(12), 2);
  LiveSurface surface(bench.start.mesh, bench.rules);
  const std::size_t vertices = surface.vertex_count();
  const ShakeFigures figures = shake(surface, bench.rules, {0, 10000, {.sweeps = sweeps}}, RunControl());
  CHECK(figures.flipped > 10);
  CHECK(figures.flipped <= figures.attempts);
  CHECK(figures.largest <= bench.start.delta());
  CHECK(surface.vertex_count() == vertices);
  CHECK(surface.compacted().triangles.size() == bench.start.mesh.triangles.size());
  CHECK(surface.compacted().triangles != bench.start.mesh.triangles);
  check_valid(surface.compacted(), bench.start, 2);
}

TEST_CASE("a pass depends on its number, not on the number of threads") {
  const Bench bench(testing::sphere(12), 2);
  const auto shaken = [&](std::uint32_t pass, unsigned threads) {
    const ThreadLimit limit(threads);
    LiveSurface surface(bench.start.mesh, bench.rules);
    shake(surface, bench.rules, {pass, 60, {.sweeps = sweeps}}, RunControl());
    return surface.compacted();
  };
  const TriangleMesh one = shaken(1, 1), two = shaken(1, 2), other = shaken(2, 1);
  CHECK(one.triangles == two.triangles);
  CHECK(one.points == two.points);
  CHECK(one.triangles != other.triangles);
}

TEST_CASE("a pass ends with its tries, and at once when cancelled") {
  const Bench bench(testing::sphere(12), 2);
  LiveSurface surface(bench.start.mesh, bench.rules);
  const ShakeFigures figures = shake(surface, bench.rules, {0, 1, {.sweeps = sweeps}}, RunControl());
  CHECK(figures.attempts >= 1);
  CHECK(figures.attempts <= 16); // a batch
  RunControl control;
  control.cancel();
  const std::uint32_t commits = surface.commits();
  CHECK(shake(surface, bench.rules, {1, 100, {.sweeps = sweeps}}, control).attempts == 0);
  CHECK(surface.commits() == commits);
}

TEST_CASE("a flip with repair leaves the edge gone and every facet proven") {
  const Bench bench(testing::sphere(12), 2);
  const LiveSurface surface(bench.start.mesh, bench.rules);
  std::size_t accepted = 0;
  for (const Facet& f : surface.complex().facets) {
    const std::uint32_t a = f.v[0], b = f.v[1];
    if (a > b) continue;
    SurfacePatch patch = surface.patch(vertices_around(surface.complex(), {a, b}, 1));
    const std::uint32_t la = patch.local_vertex(a), lb = patch.local_vertex(b);
    const auto corners = flip_corners(patch.complex, patch.complex.facet_left_of(la, lb),
                                      patch.complex.facets[patch.complex.facet_left_of(la, lb)].corner(la));
    REQUIRE(corners);
    const auto verdict = flip_with_repair(bench.rules, patch, la, lb, {.sweeps = sweeps});
    if (!verdict || !verdict->accepted()) continue;
    ++accepted;
    CHECK(patch.complex.has_edge(corners->c, corners->d)); // it was not flipped back
    for (const Facet& g : patch.complex.facets) CHECK(g.proven);
  }
  CHECK(accepted > 10);
}

TEST_CASE("no edge of a tetrahedron can be flipped") {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const Bench bench(soup, 2);
  const LiveSurface surface(bench.start.mesh, bench.rules);
  SurfacePatch patch = surface.patch(std::array{0u, 1u, 2u, 3u});
  CHECK_FALSE(flip_with_repair(bench.rules, patch, 0, 1, {.sweeps = sweeps}));
}

TEST_CASE("patches of one batch do not read what another changes") {
  const Bench bench(testing::sphere(12), 2);
  const LiveSurface surface(bench.start.mesh, bench.rules);
  PatchClaims claims(surface.complex().points.size());
  const SurfacePatch first = surface.patch(std::array{0u});
  const std::uint32_t neighbor = surface.complex().neighbors(0).front();
  claims.begin_batch();
  CHECK(claims.claim(first));
  CHECK(claims.is_read(neighbor));
  CHECK_FALSE(claims.claim(first));
  CHECK_FALSE(claims.claim(surface.patch(std::array{neighbor}))); // would change what the first one reads
  const std::vector<Vec3>& points = surface.complex().points;
  const auto farther = [&](Vec3 p, Vec3 q) { return distance(p, points[0]) < distance(q, points[0]); };
  const auto far =
      static_cast<std::uint32_t>(std::max_element(points.begin(), points.end(), farther) - points.begin());
  CHECK(claims.claim(surface.patch(std::array{far})));
  claims.begin_batch();
  CHECK_FALSE(claims.is_read(neighbor));
  CHECK(claims.claim(surface.patch(std::array{neighbor})));
}
