// Proofs tile by tile add up to the certificate of the whole mesh, whether it holds or not.
#include "input/gallery.h"
#include "input/temporary_folder.h"
#include "run/crumbs.h"
#include "run/voxel_soup.h"
#include "tiles/cut_model.h"
#include "tiles/proof_sum.h"
#include "tiles/tile_join.h"
#include "tiles/tile_piece.h"
#include "tolerance/ray_winding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>

using namespace isoscope;
using isoscope::test::voxel_surface;

namespace {

struct Proven {
  Certificate certificate;
  NormalDeviation normals;
  SmallParts crumbs;
  MeshSize size;
  std::size_t tiles = 0;
};

Proven proven_in_tiles(const TileFolder& folder, const ExpectedTopology& expected) {
  const RunParameters& p = folder.manifest().parameters;
  const double delta = folder.manifest().delta;
  const RunControl control;
  auto plan = plan_proof(folder, {p.cover, false, true});
  REQUIRE(plan.ok());
  ProofSum sum(*plan);
  for (const GridPlace& tile : plan->tiles) {
    auto proof = prove_tile(folder, *plan, tile, control);
    REQUIRE(proof.ok());
    sum.add(std::move(*proof));
  }
  REQUIRE(sum.count_sides(folder, control).ok());
  Proven all{sum.certificate(expected, delta), sum.normals(), sum.small_parts(crumb_size * delta), {}, 0};
  all.size = {sum.vertices(), sum.facets()};
  all.tiles = plan->tiles.size();
  return all;
}

/// Proves a Z that stands for an input both ways.
void check_both_ways(const TriangleSoup& input, const std::vector<Triangle3>& z, double percent,
                     std::size_t most_tiles, const RunParameters& asked = {}) {
  RunControl control;
  RunParameters p = asked;
  p.input = "test";
  p.tolerance = {percent, true};
  Preparation preparation(p, control);
  const auto scene = preparation.make(std::make_shared<const TriangleSoup>(input), {}, ThinParts::accept);
  REQUIRE(scene.ok());
  const TriangleMesh mesh = mesh_of(z);
  const Certificate whole =
      certify(mesh, preparation.volume(), (*scene)->expected, control, {p.cover, false, true});
  const NormalDeviation normals = measure_normal_deviation(mesh, preparation.volume(), control);
  const SmallParts crumbs = count_small_parts(mesh, crumb_size * (*scene)->delta);

  TileManifest manifest;
  manifest.parameters = p;
  manifest.delta = (*scene)->delta;
  const double heavy =
      1.3 * (500.0 * static_cast<double>(z.size()) + 200.0 * static_cast<double>(input.triangles.size()));
  for (const double memory : {heavy * 2, heavy / static_cast<double>(most_tiles)}) {
    const TemporaryFolder folder;
    manifest.memory = memory;
    const auto tiles = TileFolder::create(folder / "tiles", manifest, z, facets_of(input));
    REQUIRE(tiles.ok());
    const Proven sum = proven_in_tiles(*tiles, (*scene)->expected);
    const Certificate& c = sum.certificate;
    CAPTURE(sum.tiles);
    CHECK((sum.tiles == 1) == (memory > heavy));
    for (const std::string& failure : c.failures) INFO(failure);
    CHECK(c.holds() == whole.holds());
    CHECK(c.closed_manifold == whole.closed_manifold);
    CHECK(c.manifold == whole.manifold);
    CHECK(c.oriented == whole.oriented);
    CHECK(c.intersection_free == whole.intersection_free);
    CHECK(c.within_tolerance == whole.within_tolerance);
    CHECK(c.covers == whole.covers);
    // Of a mesh that leaves Ω other witnesses may tell otherwise, and the worst may be another place.
    if (whole.within_tolerance) {
      CHECK(c.separates == whole.separates);
      CHECK(c.max_distance == doctest::Approx(whole.max_distance).epsilon(0.01));
    }
    CHECK(c.topology == whole.topology);
    CHECK(c.euler_characteristic == whole.euler_characteristic);
    if (whole.oriented) CHECK(c.components == whole.components);
    CHECK(c.failures.empty() == whole.failures.empty());
    CHECK(c.input_distance.lower <= whole.input_distance.upper);
    CHECK(whole.input_distance.lower <= c.input_distance.upper);
    CHECK(sum.size.vertices == mesh.points.size());
    CHECK(sum.size.triangles == mesh.triangles.size());
    CHECK(sum.crumbs.components == crumbs.components);
    CHECK(sum.crumbs.vertices == crumbs.vertices);
    CHECK(sum.normals.points == normals.points);
    CHECK(sum.normals.mean == doctest::Approx(normals.mean).epsilon(0.001));
    CHECK(sum.normals.percentile_99 == doctest::Approx(normals.percentile_99).epsilon(0.01));
  }
}

TriangleSoup model(const char* name) {
  auto made = make_gallery_model(name);
  REQUIRE(made.ok());
  return *made;
}

} // namespace

TEST_CASE("A ray that meets edges and vertices counts each surface once") {
  const TriangleSoup cube = voxel_surface({3, 3, 3}, [](int, int, int) { return true; });
  for (int x = -1; x <= 7; ++x)
    for (int y = -1; y <= 7; ++y)
      for (int z = -1; z <= 7; ++z) {
        const Vec3 p{0.5 * x, 0.5 * y, 0.5 * z};
        const auto on = [](double c) { return c == 0 || c == 3; };
        const auto within = [](double c) { return c >= 0 && c <= 3; };
        const bool in = within(p.x) && within(p.y) && within(p.z);
        if (in && (on(p.x) || on(p.y) || on(p.z))) continue; // it lies on the surface
        int winding = 0;
        RayWinding many({p, p});
        for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
          winding += signed_crossing(cube.triangle(t), p);
          many.add(cube.triangle(t));
        }
        CHECK(winding == (in ? 1 : 0));
        CHECK(many.windings() == std::vector<int>{winding, winding});
      }
}

TEST_CASE("Proofs of tiles add up to the whole certificate of what was simplified") {
  for (const auto& [name, percent, rounds] : {std::tuple("sphere", 4.0, 1), std::tuple("torus", 2.0, 3)}) {
    CAPTURE(name);
    const TemporaryFolder folder;
    const TileFolder tiles =
        test::cut(folder / "tiles", test::parameters_of(std::string("gallery:") + name, percent), 1);
    for (int r = 0; r < rounds; ++r) {
      const auto round = tiles.round();
      REQUIRE(round.ok());
      for (std::size_t i = 0; i < (*round)->tiles.size(); ++i)
        REQUIRE(make_tile(tiles, **round, i, RunControl()).ok());
    }
    const auto z = tiles.z_before(static_cast<std::uint32_t>(rounds) + 1, all_of_space);
    REQUIRE(z.ok());
    CHECK(z->size() < tiles.manifest().triangles);
    check_both_ways(model(name), *z, percent, 8);
  }
}

TEST_CASE("Facets over many tiles, sheets close to each other and cavities are proven alike") {
  const TriangleSoup slabs = voxel_surface({24, 24, 4}, [](int, int, int z) { return z == 0 || z == 3; });
  check_both_ways(slabs, facets_of(slabs), 1, 20);
  const TriangleSoup hollow = voxel_surface({12, 12, 12}, [](int x, int y, int z) {
    const auto mid = [](int c) { return c > 3 && c < 8; };
    return !(mid(x) && mid(y) && mid(z));
  });
  check_both_ways(hollow, facets_of(hollow), 2, 8);
  // Two facets a side of the box: each lies in many tiles of what the slabs were cut into.
  const TriangleSoup box = voxel_surface({1, 1, 1}, [](int, int, int) { return true; });
  std::vector<Triangle3> large = facets_of(box);
  for (Triangle3& f : large)
    for (Vec3& p : f) p = {24 * p.x, 24 * p.y, 24 * p.z};
  const TriangleSoup fine = voxel_surface({24, 24, 24}, [](int, int, int) { return true; });
  check_both_ways(fine, large, 1, 16);
}

TEST_CASE("What is wrong is found in tiles as in the whole") {
  const TriangleSoup sphere = model("sphere");
  const std::vector<Triangle3> good = facets_of(sphere);
  SUBCASE("a hole") {
    std::vector<Triangle3> z = good;
    z.pop_back();
    check_both_ways(sphere, z, 4, 8);
  }
  SUBCASE("a facet that is turned") {
    std::vector<Triangle3> z = good;
    std::swap(z[7][0], z[7][1]);
    check_both_ways(sphere, z, 4, 8);
  }
  SUBCASE("a vertex that leaves Ω, by so much that facets meet") {
    std::vector<Triangle3> z = good;
    const Vec3 moved = good.front()[0];
    for (Triangle3& f : z)
      for (Vec3& p : f)
        if (p == moved) p = -0.9 * p;
    check_both_ways(sphere, z, 4, 8);
  }
  SUBCASE("another component, small") {
    std::vector<Triangle3> z = good;
    for (Triangle3 f : good) {
      for (Vec3& p : f) p = 0.01 * p + Vec3{1, 0, 0};
      z.push_back(f);
    }
    check_both_ways(sphere, z, 4, 8);
  }
  SUBCASE("turned inside out") {
    std::vector<Triangle3> z = good;
    for (Triangle3& f : z) std::swap(f[0], f[1]);
    check_both_ways(sphere, z, 4, 8);
  }
  SUBCASE("a component that is missing") {
    TriangleSoup two = sphere;
    const auto first = static_cast<std::uint32_t>(two.points.size());
    for (const Vec3 p : sphere.points) two.points.push_back(p + Vec3{5, 0, 0});
    for (const auto& t : sphere.triangles)
      two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    check_both_ways(two, good, 1, 8);
  }
}
