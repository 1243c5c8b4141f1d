// Single transactions: what is accepted is proven, what is refused names a reason that holds, nothing else
// changes.
#include "improve/live_surface.h"
#include "improve/support.h"
#include "tolerance/facet_certificate.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <map>

using namespace isoscope;
using isoscope::testing::Bench;

TEST_CASE("a collapse that would move the surface across a witness is refused for that reason") {
  Bench bench(testing::octahedron(1), 10);
  const LiveSurface surface(bench.start.mesh, bench.rules);
  const InputSurface wide(bench.start.volume->index(), 2, bench.start.mesh); // δ is no obstacle here
  bench.rules.input = &wide;
  const auto attempt = [&] {
    SurfacePatch patch = take_patch(surface.complex(), std::array{0u, 2u});
    return collapse_with_repair(bench.rules, patch, patch.local_vertex(0), patch.local_vertex(2),
                                {0.6, 0.6, 0}, {});
  };
  CHECK(attempt().accepted());
  bench.rules.witnesses = {{0.9, 0.02, 0}}; // inside of the octahedron, outside of what would be left
  const PatchVerdict verdict = attempt();
  CHECK(verdict.reason == Reason::witness_side);
  CHECK(verdict.witness == bench.rules.witnesses[0]);
  bench.rules.witnesses = {{0, 0, 0}, {3, 0, 0}};
  CHECK(attempt().accepted());
}

TEST_CASE("every edge of a sphere: accepted patches are proven, refused ones say why, the surface stays") {
  const Bench bench(testing::sphere(14), 4);
  const LiveSurface surface(bench.start.mesh, bench.rules);
  std::map<Reason, std::size_t> reasons;
  for (const Facet& f : surface.complex().facets) {
    const std::uint32_t a = f.v[0], b = f.v[1];
    if (a > b) continue;
    const auto candidate = collapse_candidate(bench.input, surface.complex(), a, b, {});
    REQUIRE(candidate.has_value());
    for (const int sweeps : {0, 6}) {
      // From a place 2 δ too far out, so that there is something to repair.
      const Vec3 target = (sweeps > 0 ? 1 + 2 * bench.start.delta() : 1.0) * candidate->target;
      SurfacePatch patch =
          take_patch(surface.complex(), vertices_around(surface.complex(), {a, b}, sweeps > 0 ? 1 : 0));
      const PatchVerdict verdict = collapse_with_repair(bench.rules, patch, patch.local_vertex(a),
                                                        patch.local_vertex(b), target, {sweeps, 8});
      ++reasons[verdict.reason];
      if (sweeps == 0) CHECK(verdict.sweeps.empty());
      if (!verdict.accepted()) continue;
      for (std::size_t k = 0; k < patch.complex.facets.size(); ++k) {
        if (!patch.complex.facets[k].alive()) continue;
        const Triangle3 t = patch.complex.triangle(k);
        CHECK(certify_facet(bench.input.field(), t, bench.start.delta(), bench.start.delta()).kind ==
              FacetVerdict::Kind::inside);
      }
      for (std::size_t v = 0; v < patch.vertices.size(); ++v)
        if (!patch.free[v]) CHECK(patch.complex.points[v] == patch.start_points[v]);
    }
  }
  CHECK(reasons[Reason::none] > 100);
  CHECK(surface.commits() == 0);
  CHECK(surface.compacted().points == bench.start.mesh.points);
  CHECK(surface.compacted().triangles == bench.start.mesh.triangles);
}

TEST_CASE("a patch that meets a facet elsewhere, or doubles an edge, cannot be committed") {
  TriangleSoup soup;
  testing::add_torus(soup, {0, 0, 0}, 1, 0.3, 10);
  for (auto& f : soup.triangles) std::swap(f[0], f[1]);
  Bench bench(soup, 3);
  LiveSurface surface(bench.start.mesh, bench.rules);
  SurfacePatch patch = take_patch(surface.complex(), std::array{0u});
  CHECK(surface.check(patch).accepted());
  patch.complex.points[patch.local_vertex(0)] = -1.0 * surface.complex().points[0]; // across the hole
  CHECK(surface.check(patch).reason == Reason::intersection);
  patch.complex.points[patch.local_vertex(0)] = 1.01 * surface.complex().points[0];
  REQUIRE(surface.check(patch).accepted());
  const SurfaceChange change = surface.commit(patch, EventKind::relaxation);
  CHECK(change.moves.size() == 1);
  CHECK(change.removed.empty());
  CHECK(surface.stamp(0) == 1);
  CHECK(surface.collapse_stamp(0) == 0);
  CHECK_FALSE(surface.up_to_date(patch));
}
