// A cut that streams makes the folder of one that has all in memory, or says what is wrong.
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "run/voxel_soup.h"
#include "tiles/cut_model.h"
#include "tiles/tile_piece.h"
#include "tiles/tile_stream.h"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <string>

using namespace isoscope;
using isoscope::test::voxel_surface;

namespace {

TriangleMesh mesh_of_model(const TriangleSoup& soup) {
  return {soup.points, soup.triangles};
}

TriangleSoup gallery_soup(const char* name) {
  auto made = make_gallery_model(name);
  REQUIRE(made.ok());
  return *made;
}

std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  return files;
}

std::string refusal(const TriangleMesh& mesh) {
  const TemporaryFolder folder;
  REQUIRE(write_mesh(folder / "model.off", mesh).ok());
  const auto cut = stream_into_tiles(test::parameters_of((folder / "model.off").string(), 4),
                                     folder / "tiles", test::mebibyte, RunControl());
  CHECK(TileFolder::exists(folder / "tiles") == cut.ok());
  return cut.ok() ? std::string() : cut.error().message;
}

} // namespace

TEST_CASE("What is streamed is cut into the same files, from any format") {
  const TriangleSoup hollow = voxel_surface({12, 12, 12}, [](int x, int y, int z) {
    const auto mid = [](int c) { return c > 3 && c < 8; };
    return !(mid(x) && mid(y) && mid(z));
  });
  TriangleMesh turned = mesh_of_model(gallery_soup("torus"));
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  const std::map<std::string, TriangleMesh> models{{"sphere.off", mesh_of_model(gallery_soup("sphere"))},
                                                   {"sphere.stl", mesh_of_model(gallery_soup("sphere"))},
                                                   {"turned.ply", turned},
                                                   {"hollow.obj", mesh_of_model(hollow)}};
  for (const auto& [name, mesh] : models) {
    CAPTURE(name);
    const TemporaryFolder folder;
    REQUIRE(write_mesh(folder / name, mesh).ok());
    const RunParameters p = test::parameters_of((folder / name).string(), 2);
    RunControl control;
    const auto whole = cut_into_tiles(p, folder / "whole", test::mebibyte, control);
    REQUIRE(whole.ok());
    RunParameters started = p;
    started.start = FirstZ::input;
    const auto streamed = stream_into_tiles(started, folder / "streamed", test::mebibyte, control);
    REQUIRE(streamed.ok());
    CHECK(streamed->manifest().triangles == mesh.triangles.size());
    CHECK(streamed->manifest().vertices == whole->manifest().vertices);
    CHECK(streamed->manifest().euler_characteristic == whole->manifest().euler_characteristic);
    CHECK(streamed->manifest().components == whole->manifest().components);
    CHECK(streamed->manifest().brick == whole->manifest().brick);
    CHECK(streamed->manifest().witnesses == whole->manifest().witnesses);
    CHECK(streamed->manifest().held == whole->manifest().held);
    CHECK(files_below(folder / "whole" / "input").size() > 4);
    for (const char* part : {"input", "z/0"})
      CHECK(files_below(folder / "whole" / part) == files_below(folder / "streamed" / part));
  }
}

TEST_CASE("A cut that streams refuses what is no closed surface, and what it cannot know") {
  const TriangleMesh sphere = mesh_of_model(gallery_soup("sphere"));
  CHECK(refusal(sphere).empty());
  TriangleMesh open = sphere;
  open.triangles.pop_back();
  CHECK(refusal(open).find("it is open, it has a border at") != std::string::npos);
  TriangleMesh torn = sphere;
  std::swap(torn.triangles[5][0], torn.triangles[5][1]);
  CHECK(refusal(torn).find("neighbours do not agree") != std::string::npos);
  TriangleMesh twice = sphere;
  const auto first = static_cast<std::uint32_t>(twice.points.size());
  for (const Vec3 p : sphere.points) twice.points.push_back(p + Vec3{0.5, 0.25, 0.125});
  for (const auto& t : sphere.triangles)
    twice.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  CHECK(refusal(twice).find("it meets itself") != std::string::npos);
  const TemporaryFolder folder;
  std::ofstream(folder / "quads.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  RunParameters p = test::parameters_of((folder / "quads.obj").string(), 4);
  const auto quads = stream_into_tiles(p, folder / "tiles", test::mebibyte, RunControl());
  REQUIRE(!quads.ok());
  CHECK(quads.error().message.find("more than three corners") != std::string::npos);
  p.drop_small = 1;
  CHECK(!stream_into_tiles(p, folder / "tiles", test::mebibyte, RunControl()).ok());
  CHECK(!is_to_be_streamed(p, test::mebibyte));
}
