// Points that are held: in walls and gaps without anything deeper than δ, and nowhere else.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "run/voxel_soup.h"
#include "tiles/cut_model.h"
#include "tiles/held_points.h"
#include "tiles/tile_join.h"
#include "tiles/tile_stream.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using isoscope::test::voxel_surface;

namespace {

std::vector<Vec3> held_in(const TriangleSoup& soup, double delta) {
  const ClosestPointIndex index(soup);
  HeldPoints points(index.bounds().center(), delta, 3 * delta);
  points.look(
      index, [](Vec3) { return true; }, RunControl());
  return points.held();
}

double nearest(Vec3 p, const std::vector<Vec3>& points) {
  double least = Box3::inf;
  for (const Vec3 q : points) least = std::min(least, distance(p, q));
  return least;
}

TriangleSoup plate() {
  return voxel_surface({30, 30, 2}, [](int, int, int) { return true; });
}

} // namespace

TEST_CASE("Of a plate thinner than twice the tolerance points inside are held, near to all of it") {
  const TriangleSoup soup = plate();
  const Box3 box = soup.bounds();
  const std::vector<Vec3> held = held_in(soup, 1.5);
  CHECK(held.size() > 20);
  CHECK(held.size() < 300);
  for (const Vec3 p : held)
    for (int a = 0; a < 3; ++a) {
      CHECK(p[a] > box.lo[a]);
      CHECK(p[a] < box.hi[a]);
    }
  for (const Vec3 p : soup.points) CHECK(nearest(p, held) <= 4.5);
}

TEST_CASE("Nothing is held in a cube, and of a gap what is between its walls") {
  CHECK(held_in(voxel_surface({10, 10, 10}, [](int, int, int) { return true; }), 1.5).empty());
  const TriangleSoup blocks = voxel_surface({24, 24, 14}, [](int, int, int z) { return z < 6 || z > 7; });
  const std::vector<Vec3> held = held_in(blocks, 1.5);
  CHECK(!held.empty());
  const double middle = blocks.bounds().center().z;
  for (const Vec3 p : held) CHECK(std::abs(p.z - middle) < 1);
}

TEST_CASE("A streamed cut of a thin plate ends certified, near to all of it") {
  const TriangleSoup soup = plate();
  const TemporaryFolder folder;
  const auto file = folder / "plate.ply";
  REQUIRE(write_mesh(file, TriangleMesh{soup.points, soup.triangles}).ok());
  RunParameters p = test::parameters_of(file.string(), 1, 0);
  p.tolerance = {1.5, false};
  p.start = FirstZ::input;
  const auto tiles = stream_into_tiles(p, folder / "tiles", test::mebibyte, RunControl());
  REQUIRE(tiles.ok());
  CHECK(!tiles->manifest().held.empty());
  REQUIRE(make_all_tiles(*tiles, RunControl()).ok());
  RunControl control;
  const auto joined = join_tiles(*tiles, {}, control);
  REQUIRE(joined.ok());
  CHECK(joined->result.certificate.holds());
  CHECK(joined->result.certificate.input_distance.upper <= 4.5);
  CHECK(joined->result.size().vertices < 200);
}
