// OpenVDB: level sets and fog volumes in the world's units; what is no grid of floats is refused.
#include "input/grid_readers.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;

namespace {

void write(const std::filesystem::path& file, const openvdb::GridPtrVec& grids) {
  openvdb::initialize();
  openvdb::io::File(file.string()).write(grids);
}

openvdb::FloatGrid::Ptr sphere() {
  openvdb::initialize();
  return openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(2, {1, 2, 3}, 0.1F);
}

double value_near(const ScalarGrid& grid, Vec3 p) {
  std::array<std::size_t, 3> at{};
  for (int a = 0; a < 3; ++a)
    at[static_cast<std::size_t>(a)] =
        static_cast<std::size_t>(std::lround((p[a] - grid.origin[a]) / grid.spacing[a]));
  return static_cast<double>(grid.at(at[0], at[1], at[2]));
}

} // namespace

TEST_CASE("a level set keeps its distances and its place, with background around it") {
  const TemporaryFolder folder;
  const auto file = folder / "sphere.vdb";
  write(file, {sphere()});
  CHECK(is_grid_file(file));
  const auto grid = read_grid(file, RunControl());
  REQUIRE(grid.ok());
  CHECK(grid->spacing.x == doctest::Approx(0.1));
  CHECK(grid->box().lo.x < -1.2);
  CHECK(grid->box().hi.z > 5.2);
  CHECK(value_near(*grid, {3.1, 2, 3}) == doctest::Approx(0.1).epsilon(0.05));
  CHECK(value_near(*grid, {1, 2, 1.2}) == doctest::Approx(-0.2).epsilon(0.05));
  CHECK(value_near(*grid, {1, 2, 3}) == doctest::Approx(-0.3)); // inside of the band: its half width
  CHECK(grid->values.front() == doctest::Approx(0.3));
}

TEST_CASE("of several grids the first one of floats is read, a fog volume too") {
  const TemporaryFolder folder;
  const auto fog = sphere();
  openvdb::tools::sdfToFogVolume(*fog);
  fog->setName("density");
  const auto velocity = openvdb::Vec3SGrid::create();
  velocity->setName("a velocity");
  const auto file = folder / "smoke.vdb";
  write(file, {velocity, fog});
  const auto grid = read_grid(file, RunControl());
  REQUIRE(grid.ok());
  CHECK(grid->name == "smoke density");
  CHECK(*std::max_element(grid->values.begin(), grid->values.end()) == 1);
  CHECK(grid->values.front() == 0);

  write(file, {velocity});
  const auto none = read_grid(file, RunControl());
  REQUIRE_FALSE(none.ok());
  CHECK(none.error().message.find("a velocity (vec3s)") != std::string::npos);
}

TEST_CASE("turned grids, empty ones and damaged files are refused") {
  const TemporaryFolder folder;
  const auto file = folder / "a.vdb";
  const auto refused = [&](std::string_view words) {
    const auto grid = read_grid(file, RunControl());
    REQUIRE_FALSE(grid.ok());
    CAPTURE(grid.error().line());
    CHECK(grid.error().message.find(words) != std::string::npos);
  };
  const auto turned = sphere();
  turned->transform().postRotate(0.3);
  write(file, {turned});
  refused("oblique");
  write(file, {openvdb::FloatGrid::create()});
  refused("without an active voxel");
  write(file, {sphere()});
  const std::string bytes = bytes_of(file);
  folder.file("a.vdb", bytes.substr(0, bytes.size() / 2));
  refused("a.vdb");
  folder.file("a.vdb", bytes.substr(0, 20));
  refused("a.vdb");
}
