// Whole runs in tiles: known answers, few more vertices than without, and the same mesh whichever way they
// are made.
#include "improve/improver.h"
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "run/voxel_soup.h"
#include "simplify/first_surface.h"
#include "support/models.h"
#include "tiles/cut_model.h"
#include "tiles/tile_join.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <thread>
#include <tuple>

using namespace isoscope;
using namespace isoscope::test;

namespace {

JoinedTiles joined(const TileFolder& folder) {
  RunControl control;
  auto made = join_tiles(folder, {}, control);
  REQUIRE(made.ok());
  return *made;
}

/// As it is written.
TriangleMesh mesh_of_tiles(const TileFolder& folder) {
  RunControl control;
  const auto file = folder.folder() / "joined.off";
  const auto made = join_tiles(folder, file, control);
  REQUIRE(made.ok());
  const auto read = read_mesh(file);
  REQUIRE(read.ok());
  CHECK(made->result.size().vertices == read->points.size());
  CHECK(made->result.size().triangles == read->triangles.size());
  return {read->points, read->triangles};
}

/// Without tiles.
std::size_t whole_vertices(RunParameters p) {
  p.start = FirstZ::input;
  p.conditions[2] = false;
  RunControl control;
  struct : Gate {
    Verdict pass(const Journal&, const Event&) override { return Verdict::go_on; }
    CriteriaParameters wanted_parameters() const override { return {}; }
  } gate;
  Pipeline pipeline(p, std::make_shared<Journal>(), gate, control);
  REQUIRE(pipeline.prepare().ok());
  return pipeline.run()->mesh.points.size();
}

} // namespace

TEST_CASE("Facets that are not wholly in the box stay, and what changes stays in it") {
  const TriangleSoup sphere = *make_gallery_model("sphere");
  const ClosestPointIndex index(sphere);
  const ChangeBox box{{-2, -2, 0.1}, {2, 2, 2}};
  const auto changes = [&](const Triangle3& f) {
    return std::all_of(f.begin(), f.end(), [&](Vec3 p) { return box.holds(p); });
  };
  const auto rest_of = [&](const TriangleMesh& mesh) {
    std::vector<Triangle3> rest;
    for (const auto& t : mesh.triangles)
      if (const Triangle3 f{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}; !changes(f))
        rest.push_back(f);
    make_canonical(rest);
    return rest;
  };
  struct : ImproverObserver {
    bool accepted(const SurfaceChange&, const ImproverVerdict&) override { return true; }
    bool rejected(const ImproverVerdict&) override { return true; }
  } nobody;
  TriangleMesh mesh{sphere.points, sphere.triangles};
  const std::vector<Triangle3> before = rest_of(mesh);
  ImproverOptions options;
  options.effort = 2;
  options.preserve_normals = false;
  improve(mesh, ImproverGround{index, 0.05, {}, nullptr, box}, nullptr, options, RunControl(), nobody);
  CHECK(rest_of(mesh) == before);
  CHECK(mesh.triangles.size() < before.size() + (sphere.triangles.size() - before.size()) / 2);
}

TEST_CASE("Runs in tiles end certified, with the topology of the input and not many more vertices") {
  for (const auto& [name, percent, chi] :
       {std::tuple("gallery:sphere", 4.0, 2L), std::tuple("gallery:torus", 2.0, 0L)}) {
    CAPTURE(name);
    const TemporaryFolder folder;
    const RunParameters p = parameters_of(name, percent);
    const TileFolder tiles = cut(folder / "tiles", p, 1.4);
    const auto first = tiles.round();
    REQUIRE(first.ok());
    CHECK((*first)->tiles.size() > 4);
    RunControl control;
    REQUIRE(make_all_tiles(tiles, control).ok());
    CHECK(*tiles.complete_rounds() > 4);
    const JoinedTiles run = joined(tiles);
    CHECK(run.result.certificate.failures.empty());
    CHECK(run.result.certificate.holds());
    CHECK(run.result.certificate.euler_characteristic == chi);
    CHECK(run.result.exit_status() == 0);
    const double whole = static_cast<double>(whole_vertices(p));
    CHECK(static_cast<double>(run.result.size().vertices) <= 1.2 * whole);
  }
}

TEST_CASE("Sheets near to each other, with vertices on the planes of tiles, never meet") {
  // Two slabs of cubes with whole corners, where the planes of tiles are, between them less than a facet is
  // long in the end.
  const TriangleSoup slabs = voxel_surface({24, 24, 4}, [](int, int, int z) { return z == 0 || z == 3; });
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "slabs.off";
  REQUIRE(write_mesh(file, TriangleMesh{slabs.points, slabs.triangles}).ok());
  RunParameters p = parameters_of(file.string(), 1);
  p.tolerance = {0.3, false};
  const TileFolder tiles = cut(folder / "tiles", p, 2.1);
  CHECK((*tiles.round())->tiles.size() > 2);
  REQUIRE(make_all_tiles(tiles, RunControl()).ok());
  const JoinedTiles run = joined(tiles);
  CHECK(run.result.certificate.failures.empty());
  CHECK(run.result.certificate.holds());
  CHECK(run.result.certificate.components == 2);
  CHECK(run.result.certificate.euler_characteristic == 4);
  CHECK(run.result.size().vertices <= 60); // two boxes have 16 corners
}

TEST_CASE("The mesh is the same backwards, by two at once, and after stops in the middle of tiles") {
  const TemporaryFolder folder;
  const RunParameters p = parameters_of("gallery:sphere", 4);
  const auto mesh_by = [&](const char* name, const std::function<void(const TileFolder&)>& make) {
    const TileFolder tiles = cut(folder / name, p, 1);
    make(tiles);
    return mesh_of_tiles(tiles);
  };
  const TriangleMesh once =
      mesh_by("once", [](const TileFolder& tiles) { REQUIRE(make_all_tiles(tiles, RunControl()).ok()); });
  const TriangleMesh backwards = mesh_by("backwards", [](const TileFolder& tiles) {
    for (;;) {
      const auto round = tiles.round();
      REQUIRE(round.ok());
      if (!*round) return;
      for (std::size_t i = (*round)->tiles.size(); i-- > 0;)
        REQUIRE(make_tile_if_missing(tiles, **round, i, RunControl()).ok());
    }
  });
  const TriangleMesh by_two = mesh_by("two", [](const TileFolder& tiles) {
    std::thread other([&tiles] { static_cast<void>(make_all_tiles(tiles, RunControl())); });
    static_cast<void>(make_all_tiles(tiles, RunControl()));
    other.join();
    REQUIRE(make_all_tiles(tiles, RunControl()).ok());
  });
  const TriangleMesh stopped = mesh_by("stopped", [](const TileFolder& tiles) {
    for (double seconds = 0.05;; seconds *= 1.5) {
      RunControl control;
      control.cancel_after(seconds);
      const Status made = make_all_tiles(tiles, control);
      if (made) return;
      REQUIRE(made.error().code == ErrorCode::cancelled);
    }
  });
  for (const TriangleMesh* mesh : {&backwards, &by_two, &stopped}) {
    CHECK(mesh->points == once.points);
    CHECK(mesh->triangles == once.triangles);
  }
}

TEST_CASE("What cannot be cut, joined or gone on with is said") {
  const TemporaryFolder folder;
  RunControl control;
  const auto message = [](const auto& result) {
    return result.ok() ? std::string() : result.error().message;
  };
  CHECK(message(cut_into_tiles(parameters_of("gallery:hemisphere", 5), folder / "a", mebibyte, control))
            .find("it is open") != std::string::npos);
  CHECK(!TileFolder::exists(folder / "a"));
  RunParameters lattice = parameters_of("gallery:sphere", 5);
  lattice.start = FirstZ::lattice;
  CHECK(message(cut_into_tiles(lattice, folder / "a", mebibyte, control)).find("lattice") !=
        std::string::npos);
  CHECK(message(TileFolder::open(folder / "a")).find("has no tiles") != std::string::npos);
  const RunParameters p = parameters_of("gallery:sphere", 5);
  const TileFolder tiles = cut(folder / "a", p, 1);
  CHECK(message(cut_into_tiles(p, folder / "a", mebibyte, control)).find("has tiles already") !=
        std::string::npos);
  CHECK(message(join_tiles(tiles, {}, control)).find("tiles left") != std::string::npos);
  CHECK(is_run_of(tiles, p, mebibyte));
  RunParameters other = p;
  other.tolerance.value = 4;
  CHECK(!is_run_of(tiles, other, mebibyte));
  other = p;
  other.threads = 3;
  CHECK(is_run_of(tiles, other, mebibyte));
}

TEST_CASE("Elephant in tiles" * doctest::test_suite("soak")) {
  const auto model = demo_model("elephant.off");
  if (!model) return;
  const TemporaryFolder folder;
  const RunParameters p = parameters_of(model->string(), 0.3);
  const TileFolder tiles = cut(folder / "tiles", p, 2.8);
  REQUIRE(make_all_tiles(tiles, RunControl()).ok());
  const JoinedTiles run = joined(tiles);
  CHECK(run.result.certificate.holds());
  CHECK(run.result.certificate.euler_characteristic == -4);
  CHECK(static_cast<double>(run.result.size().vertices) <= 1.05 * static_cast<double>(whole_vertices(p)));
}
