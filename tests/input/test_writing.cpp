// Writing either leaves a whole file or the old one, and says what went wrong.
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <csignal>
#include <limits>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace isoscope;

namespace {

TriangleMesh triangle() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

std::size_t files_in(const TemporaryFolder& folder) {
  const std::filesystem::directory_iterator all(folder.path());
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

void check_error(const Status& status, ErrorCode code) {
  REQUIRE_FALSE(status.ok());
  CHECK(status.error().code == code);
  CHECK_FALSE(status.error().remedy.empty());
}

} // namespace

TEST_CASE("names and places that cannot be written are found before") {
  const TemporaryFolder folder;
  check_error(check_writable_mesh(folder / "a.xyz"), ErrorCode::usage);
  check_error(check_writable_mesh(folder / "a"), ErrorCode::usage);
  check_error(check_writable_mesh(folder / "missing/a.off"), ErrorCode::io);
  std::filesystem::create_directory(folder / "folder.off");
  check_error(check_writable_mesh(folder / "folder.off"), ErrorCode::io);
  check_error(write_mesh(folder / "folder.off", triangle()), ErrorCode::io);
  check_error(write_mesh(folder / "missing/a.off", triangle()), ErrorCode::io);
  CHECK(check_writable_mesh(folder / "a.STL").ok());
  CHECK(files_in(folder) == 1); // the question leaves nothing behind
  if (::geteuid() != 0) {
    REQUIRE(::chmod(folder.path().c_str(), 0500) == 0);
    check_error(check_writable_mesh(folder / "a.off"), ErrorCode::io);
    REQUIRE(::chmod(folder.path().c_str(), 0700) == 0);
  }
}

TEST_CASE("a file that cannot be finished leaves the old one and no rest") {
  const TemporaryFolder folder;
  const auto model = make_gallery_model("sphere");
  REQUIRE(model.ok());
  const TriangleMesh mesh{model->points, model->triangles};
  REQUIRE(write_mesh(folder / "a.off", triangle()).ok());
  const std::string before = bytes_of(folder / "a.off");

  // A limit on file size fails a write in its midst as a full disk does.
  rlimit old{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &old) == 0);
  const rlimit small{4096, old.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  std::vector<Status> results;
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"})
    results.push_back(write_mesh(folder / name, mesh));
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &old) == 0);
  std::signal(SIGXFSZ, handler);

  for (const Status& status : results) check_error(status, ErrorCode::io);
  CHECK(bytes_of(folder / "a.off") == before);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("links are followed, and what a format cannot hold is refused") {
  const TemporaryFolder folder;
  REQUIRE(write_mesh(folder / "real.off", triangle()).ok());
  std::filesystem::create_symlink("real.off", folder / "link.off");
  TriangleMesh mesh = triangle();
  mesh.points[1].x = 7;
  REQUIRE(write_mesh(folder / "link.off", mesh).ok());
  CHECK(std::filesystem::is_symlink(folder / "link.off"));
  CHECK(read_mesh(folder / "real.off")->points[1].x == 7);

  mesh.points[1].x = 1e39;
  check_error(write_mesh(folder / "a.stl", mesh), ErrorCode::io);
  CHECK(write_mesh(folder / "a.ply", mesh).ok());
  mesh.points[1].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(write_mesh(folder / "b.off", mesh).ok());
  mesh = triangle();
  mesh.triangles[0][2] = 3;
  CHECK_FALSE(write_mesh(folder / "b.off", mesh).ok());
}

TEST_CASE("labels of facets are properties in PLY and groups in OBJ") {
  const TemporaryFolder folder;
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}}};
  mesh.labels = {{+1, -2}, {-1, -2}, {+1, -2}};
  REQUIRE(write_mesh(folder / "a.obj", mesh).ok());
  const std::string text = bytes_of(folder / "a.obj");
  CHECK(text.ends_with("g front_1_back_-2\nf 1 2 3\nf 1 3 4\ng front_-1_back_-2\nf 1 4 2\n"));
  REQUIRE(write_mesh(folder / "a.ply", mesh).ok());
  const std::string bytes = bytes_of(folder / "a.ply");
  CHECK(bytes.find("property char front\nproperty char back\nend_header") != std::string::npos);
  CHECK(bytes.ends_with(std::string("\x01\xfe", 2)));
  for (const char* name : {"a.obj", "a.ply"}) {
    const auto back = read_mesh(folder / name);
    REQUIRE(back.ok());
    CHECK(back->triangles.size() == 3);
    CHECK(back->points.size() == 4);
  }
}
