// Surfaces between rooms: their strata, what collapses keep of them, and whole runs on walls with known
// answers.
#include "base/parallel.h"
#include "improve/patch_moves.h"
#include "improve/room_mesh.h"
#include "improve/support.h"
#include "run/certificate.h"
#include "tolerance/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

FacetComplex complex_of(const TriangleMesh& mesh) {
  FacetComplex complex;
  complex.points = mesh.points;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    complex.facets.emplace_back().v = mesh.triangles[f];
    complex.facets.back().labels = mesh.labels[f];
  }
  complex.build_stars();
  complex.strata = find_strata(complex);
  return complex;
}

TriangleMesh mesh_of(const FacetComplex& complex) {
  TriangleMesh mesh;
  mesh.points = complex.points;
  for (const Facet& f : complex.facets) {
    if (!f.alive()) continue;
    mesh.triangles.push_back(f.v);
    mesh.labels.push_back(f.labels);
  }
  return mesh;
}

std::size_t count(const FacetComplex& complex, Stratum stratum) {
  std::size_t n = 0;
  for (std::uint32_t v = 0; v < complex.points.size(); ++v)
    n += complex.alive_vertex(v) && complex.strata[v].stratum == stratum ? 1u : 0u;
  return n;
}

std::vector<std::vector<std::uint32_t>> curves_of(const std::vector<VertexStratum>& strata) {
  std::vector<std::vector<std::uint32_t>> curves;
  for (const VertexStratum& at : strata) curves.push_back(at.curves);
  return curves;
}

/// Every region closed, oriented and a ball.
void check_balls(const TriangleMesh& mesh, std::size_t rooms) {
  const std::vector<RegionCertificate> regions = certify_regions(mesh);
  REQUIRE(regions.size() == rooms + 1);
  for (const RegionCertificate& r : regions) {
    CAPTURE(r.label);
    CHECK_MESSAGE(r.failure.empty(), r.failure);
    CHECK(r.euler_characteristic == 2);
    CHECK(r.components == 1);
  }
}

} // namespace

TEST_CASE("strata of boxes that share walls") {
  const FacetComplex two = complex_of(room_mesh({2, 1, 1}, 1));
  CHECK(count(two, Stratum::curve) == 4);
  CHECK(count(two, Stratum::sheet) == 8);
  for (std::uint32_t v = 0; v < 12; ++v) {
    const VertexStratum& at = two.strata[v];
    CHECK(at.on_curve() == (two.points[v].x == 1));
    CHECK(at.curves.size() == (at.on_curve() ? 2 : 0));
    CHECK_FALSE(at.rigid);
    for (const std::uint32_t end : at.curves) CHECK(two.strata[end].leads_to(v));
    CHECK(two.star(v).size() == two.stars[v].size());
  }
  const FacetComplex eight = complex_of(room_mesh({2, 2, 2}, 2));
  // The corner in the middle, and the middles of the six outer sides.
  CHECK(count(eight, Stratum::point) == 7);
  const auto middle = static_cast<std::size_t>(
      std::find(eight.points.begin(), eight.points.end(), Vec3{1, 1, 1}) - eight.points.begin());
  CHECK(eight.strata[middle].curves.size() == 6);
  CHECK_FALSE(eight.strata[middle].rigid);
}

TEST_CASE("where sheets end, or touch in a point, nothing moves") {
  TriangleMesh open = room_mesh({2, 1, 1}, 2);
  open.triangles.pop_back();
  open.labels.pop_back();
  const FacetComplex complex = complex_of(open);
  std::size_t rigid = 0;
  for (const VertexStratum& at : complex.strata) {
    if (!at.rigid) continue;
    ++rigid;
    CHECK(at.stratum == Stratum::point);
  }
  CHECK(rigid == 3);
}

TEST_CASE("a collapse keeps the boundary of each region a surface") {
  const FacetComplex two = complex_of(room_mesh({2, 1, 1}, 2));
  const auto at = [&](Vec3 p) {
    return static_cast<std::uint32_t>(std::find(two.points.begin(), two.points.end(), p) -
                                      two.points.begin());
  };
  const std::uint32_t corner = at({1, 0, 0}), beside = at({1, 0.5, 0}), wall = at({1, 0.5, 0.5}),
                      outer = at({0.5, 0, 0});
  CHECK(two.on_curve(corner, beside));
  CHECK(two.link_condition(corner, beside)); // along the curve
  CHECK(two.link_condition(corner, outer));  // a sheet's vertex goes to the curve and the curve stays
  CHECK(pinned_end(two, outer, corner) == corner);
  CHECK(pinned_end(two, corner, outer) == corner);
  CHECK_FALSE(pinned_end(two, corner, beside));
  CHECK(two.has_edge(corner, wall));
  CHECK(two.link_condition(corner, wall));
  // Four rooms along an edge are no strata of T, but may come about where a wall between two is lost.
  const FacetComplex four = complex_of(room_mesh({2, 2, 1}, 1));
  const auto edge = four.edges();
  const auto with_four = std::count_if(edge.begin(), edge.end(), [&](const auto& e) {
    return std::count_if(four.stars[e.first].begin(), four.stars[e.first].end(),
                         [&](std::uint32_t f) { return four.facets[f].has(e.second); }) == 4;
  });
  CHECK(with_four == 1);
  // A region of four facets is the least.
  const FacetComplex tetrahedron = complex_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                                               std::vector<LabelPair>(4, LabelPair{+1, -2})});
  for (const auto& [a, b] : tetrahedron.edges()) CHECK_FALSE(tetrahedron.link_condition(a, b));
}

TEST_CASE("a wall that slides away from its rooms is as bad as one that leaves the input") {
  const std::vector<Vec3> places{{0, 0, 1}, {0, 0, -1}, {1, 0, 1}};
  const std::vector<std::int8_t> labels{1, -1, -2};
  const NearestSample samples(places, labels);
  const TriangleMesh wall{{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}, {{+1, -1}}};
  const RoomSamples rooms = room_samples(wall, samples, 0.5);
  CHECK(rooms.reach == doctest::Approx(1.01 * 4 * 0.5));
  CHECK(rooms.at({0, 0, 0}, -1).value == 0);
  CHECK(rooms.at({0, 0, 0}, -7).value == 0); // no samples tell anything of it
  const RoomSamples::Distance d = rooms.at({0, 0, rooms.reach - 1}, -1);
  CHECK(d.value == doctest::Approx(0.5));
  CHECK(d.direction.z > 0);
  const double step = 1e-4;
  CHECK(rooms.at({0, 0, rooms.reach - 1 + step}, -1).value - d.value ==
        doctest::Approx(step * d.direction.z));
  // What has slid already may stay, and goes no farther.
  CHECK(room_samples({{{3, 0, 0}, {3.1, 0, 0}, {3, 0.1, 0}}, {{0, 1, 2}}, {{+1, -1}}}, samples, 0.5).reach >
        3);
}

TEST_CASE("collapses and flips keep the regions, and curves are where the facets have them") {
  for (const std::array<int, 3> cubes : {std::array{2, 1, 1}, {2, 2, 1}, {2, 2, 2}}) {
    FacetComplex complex = complex_of(room_mesh(cubes, 3));
    const auto rooms = static_cast<std::size_t>(cubes[0] * cubes[1] * cubes[2]);
    check_balls(mesh_of(complex), rooms);
    Random random(4);
    std::size_t collapses = 0;
    for (int i = 0; i < 20000; ++i) {
      const Facet& facet = complex.facets[random.below(complex.facets.size())];
      if (!facet.alive()) continue;
      const std::size_t k = random.below(3);
      const std::uint32_t a = facet.v[k], b = facet.v[(k + 1) % 3];
      if (random.below(4) == 0) {
        const auto plan = flip_corners(complex, complex.stars[a][0], 0);
        if (plan && !complex.has_edge(plan->c, plan->d)) apply_flip(complex, *plan);
        continue;
      }
      if (!complex.link_condition(a, b)) continue;
      complex.collapse(a, b);
      ++collapses;
      if (collapses % 20 != 0) continue;
      REQUIRE(curves_of(find_strata(complex)) == curves_of(complex.strata));
      check_balls(mesh_of(complex), rooms);
    }
    CHECK(collapses > 50);
    CHECK(curves_of(find_strata(complex)) == curves_of(complex.strata));
    check_balls(mesh_of(complex), rooms);
  }
}

TEST_CASE("boxes that share walls come down to their corners") {
  struct Known {
    std::array<int, 3> cubes;
    std::size_t vertices;
  };
  for (const Known& known : {Known{{2, 1, 1}, 12}, Known{{2, 2, 1}, 18}, Known{{2, 2, 2}, 27}}) {
    const TriangleMesh fine = room_mesh(known.cubes, 4);
    Start start({fine.points, fine.triangles, {}}, 3);
    TriangleMesh mesh = fine;
    Listener listener;
    improve(mesh, *start.volume, nullptr, with_effort(2), RunControl(), listener);
    CHECK(mesh.points.size() == known.vertices);
    check_balls(mesh, static_cast<std::size_t>(known.cubes[0] * known.cubes[1] * known.cubes[2]));
    ExpectedTopology expected;
    expected.euler_characteristic = known.cubes[0] * known.cubes[1] * known.cubes[2] + 1;
    const Certificate c = certify(mesh, *start.volume, expected, RunControl());
    CHECK_MESSAGE(c.holds(), (c.failures.empty() ? "" : c.failures.front()));
  }
}

TEST_CASE("the improver between rooms gives the same on any number of threads") {
  const TriangleMesh fine = room_mesh({2, 2, 1}, 6);
  Start start({fine.points, fine.triangles, {}}, 2);
  std::vector<TriangleMesh> results;
  for (const unsigned threads : {1u, 4u}) {
    const ThreadLimit limit(threads);
    Listener listener;
    results.push_back(fine);
    improve(results.back(), *start.volume, nullptr, with_effort(1), RunControl(), listener);
  }
  CHECK(results[0].points == results[1].points);
  CHECK(results[0].triangles == results[1].triangles);
  CHECK(results[0].labels == results[1].labels);
}
