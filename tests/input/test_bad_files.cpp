// Every kind of unusable file is refused with one line that names it, and soon.
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

#include <sys/stat.h>
#include <unistd.h>

using namespace isoscope;

namespace {

/// Refused with this code; the line names the file and contains `words`.
void check_refused(const std::filesystem::path& file, ErrorCode code, std::string_view words) {
  const auto mesh = read_mesh(file);
  CAPTURE(file.string());
  REQUIRE_FALSE(mesh.ok());
  const std::string line = mesh.error().line();
  CAPTURE(line);
  CHECK(mesh.error().code == code);
  CHECK(line.find(file.string()) != std::string::npos);
  CHECK(line.find(words) != std::string::npos);
  CHECK(line.find('\n') == std::string::npos);
  CHECK_FALSE(mesh.error().remedy.empty());
}

void check_bad(const TemporaryFolder& folder, std::string_view name, std::string_view bytes,
               std::string_view words) {
  check_refused(folder.file(name, bytes), ErrorCode::bad_input, words);
}

const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list int int vertex_indices\nend_header\n";

} // namespace

TEST_CASE("what is no readable file") {
  const TemporaryFolder folder;
  check_refused(folder / "missing.off", ErrorCode::bad_input, "No such file");
  check_refused(folder.path(), ErrorCode::bad_input, "folder");
  check_refused("/dev/zero", ErrorCode::bad_input, "device");
  const auto pipe = folder / "pipe.off";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  check_refused(pipe, ErrorCode::bad_input, "pipe");
  check_bad(folder, "empty.off", "", "empty");
  const auto locked = folder.file("locked.off", "OFF\n");
  REQUIRE(::chmod(locked.c_str(), 0) == 0);
  if (::access(locked.c_str(), R_OK) != 0) check_refused(locked, ErrorCode::bad_input, "ermission");
}

TEST_CASE("garbage is named by what it lacks") {
  const TemporaryFolder folder;
  check_bad(folder, "a.off", "hello world\n", "OFF");
  check_bad(folder, "a.ply", "hello world\n", "ply");
  check_bad(folder, "a.obj", "hello world\n", "neither");
  check_bad(folder, "a.stl", "hello world\n", "format");
  check_bad(folder, "a.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "PNG");
  check_bad(folder, "a.bin", std::string("\x01\0\x02", 3), "binary");
  check_bad(folder, "a.obj", "v 0 0 0\n\x01\x02\x03\n", "line 2");
}

TEST_CASE("huge files of zeros end at once") {
  const TemporaryFolder folder;
  for (const char* name : {"z.off", "z.obj", "z.ply", "z.stl", "z"}) {
    const auto file = folder.file(name, "");
    std::filesystem::resize_file(file, std::uintmax_t{8} << 30);
    CHECK_FALSE(read_mesh(file).ok());
    std::filesystem::remove(file);
  }
  for (const std::string text : {"OFF\n3 1 0\n0 0 0\n", "v 0 0 0\n", "solid a\n"}) {
    const auto file = folder.file("tail", text);
    std::filesystem::resize_file(file, std::uintmax_t{8} << 30);
    CHECK_FALSE(read_mesh(file).ok());
  }
}

TEST_CASE("counts that the file or the machine cannot hold are not believed") {
  const TemporaryFolder folder;
  check_bad(folder, "a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", "4000000000 vertices");
  check_bad(folder, "b.off", "OFF\n99999999999999999999 1 0\n0 0 0\n", "line 2");
  check_bad(folder, "c.off", "OFF\n-3 1 0\n0 0 0\n", "line 2");
  check_bad(folder, "d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "line 6");
  check_bad(
      folder, "a.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float "
      "y\nproperty float z\nend_header\n1234",
      "4000000000 rows");
  check_bad(folder, "b.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n2147483648 0 1 2\n", "line 13");
  std::string stl(84, '\0');
  stl.replace(80, 4, "\xff\xff\xff\xff");
  check_bad(folder, "a.stl", stl + std::string(50, '\0'), "4294967295 triangles");
  check_bad(folder, "b.stl", std::string(84, '\0'), "neither");
}

TEST_CASE("truncation, wrong words and wrong indices are placed by line") {
  const TemporaryFolder folder;
  check_bad(folder, "a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "ends before");
  check_bad(folder, "b.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "line 4: \"x\"");
  check_bad(folder, "c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6");
  check_bad(folder, "d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 6");
  check_bad(folder, "e.off", "OFF\n3 1 0\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "decimal point");
  check_bad(folder, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4");
  check_bad(folder, "b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4");
  check_bad(folder, "c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "line 4");
  check_bad(folder, "d.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1");
  check_bad(folder, "e.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n", "line 4");
  check_bad(folder, "a.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "face 0");
  check_bad(folder, "b.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "ends before");
  check_bad(folder, "c.ply", ply_header + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "length");
  check_bad(folder, "d.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n", "header");
  check_bad(folder, "e.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
            "property y");
  check_bad(folder, "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n", "line 6");
  check_bad(folder, "b.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n",
            "three");
}

TEST_CASE("coordinates that are not finite or out of all measure") {
  const TemporaryFolder folder;
  for (const std::string bad : {"nan", "inf", "-inf", "1e999", "NaN"}) {
    check_bad(folder, "a.off", "OFF\n3 1 0\n0 0 0\n" + bad + " 0 0\n0 1 0\n3 0 1 2\n", "line 4");
    check_bad(folder, "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 " + bad + "\nf 1 2 3\n", "line 3");
    check_bad(folder, "a.ply", ply_header + "0 0 0\n1 0 0\n0 1 " + bad + "\n3 0 1 2\n", "line 12");
  }
  check_bad(folder, "b.off", "OFF\n3 1 0\n0 0 0\n1e200 0 0\n0 1 0\n3 0 1 2\n", "Rescale");
  check_bad(folder, "c.off", "OFF\n3 1 0\n0 0 0\n1e-200 0 0\n0 1e-200 0\n3 0 1 2\n", "Rescale");
}

TEST_CASE("files without a surface") {
  const TemporaryFolder folder;
  check_bad(folder, "a.off", "OFF\n0 0 0\n", "neither");
  check_bad(folder, "b.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n", "one point");
  check_bad(folder, "c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", "degenerate");
  check_bad(folder, "d.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 0 1\n2 0 1\n", "degenerate");
}
