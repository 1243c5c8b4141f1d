// Points without triangles, in every dialect: read as meant, with a word on what was found and left out.
#include "input/input_mesh.h"
#include "input/mesh_io.h"
#include "input/point_files.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;

namespace {

const std::vector<Vec3> wanted{{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, -2}, {0.25, 0.5, 1}};

/// The points of `wanted`; `notes`: a part of each of its notes, in order.
void check_points(const std::filesystem::path& file, const std::vector<std::string>& notes = {}) {
  CAPTURE(file.filename().string());
  const auto mesh = read_input_mesh(file, RunControl{});
  if (!mesh) FAIL(mesh.error().line());
  CHECK(mesh->soup.is_point_set());
  CHECK(mesh->soup.points == wanted);
  CHECK(mesh->soup.bounds().longest_edge() == 3);
  REQUIRE(mesh->notes.size() == notes.size());
  for (std::size_t i = 0; i < notes.size(); ++i) {
    CAPTURE(mesh->notes[i].text);
    CHECK(mesh->notes[i].text.find(notes[i]) != std::string::npos);
  }
}

void check_bad(const std::filesystem::path& file, const std::string& words) {
  CAPTURE(file.filename().string());
  const auto mesh = read_mesh(file);
  REQUIRE_FALSE(mesh.ok());
  CAPTURE(mesh.error().line());
  CHECK(mesh.error().code == ErrorCode::bad_input);
  CHECK(mesh.error().line().find(words) != std::string::npos);
}

/// The rows of `wanted`, with `separator` between x, y and z and `behind` at the end of each row.
std::string rows(const std::string& separator, const std::string& behind = "", char point = '.') {
  std::string text;
  for (const Vec3 p : wanted) {
    for (int a = 0; a < 3; ++a) {
      std::string number = std::to_string(p[a]);
      number[number.find('.')] = point;
      text += (a == 0 ? "" : separator) + number;
    }
    text += behind + "\n";
  }
  return text;
}

} // namespace

TEST_CASE("rows of numbers, whatever separates them") {
  const TemporaryFolder folder;
  for (const char* separator : {" ", "  ", "\t", ",", ", ", ";", " ; ", " ,\t"})
    for (const char* name : {"a.xyz", "a.asc", "a.txt", "a.pts", "a.csv", "a"})
      check_points(folder.file(name, rows(separator)));
  check_points(folder.file("comma.csv", rows(",", ",")));
  check_points(folder.file("decimal.csv", rows(";", "", ',')), {"decimal points"});
  check_points(folder.file("decimal.txt", rows(" ", "", ',')), {"decimal points"});
  check_points(folder.file("comments.xyz", "# a scan\n\n// of a house\n" + rows(" ", " # a point")));
  std::string old_mac = rows(" ");
  for (char& c : old_mac) c = c == '\n' ? '\r' : c;
  check_points(folder.file("cr.xyz", old_mac));
  check_points(folder.file("crlf.xyz", rows(" ", "\r")));
}

TEST_CASE("what the columns mean is found and told") {
  const TemporaryFolder folder;
  check_points(folder.file("normals.xyz", rows(" ", " 0.6 0 0.8")), {"normals and are passed over"});
  check_points(folder.file("colours.xyz", rows(" ", " 255 0 17")), {"look like colours"});
  check_points(folder.file("real.xyz", rows(" ", " 0.5 0 0.125")), {"look like colours"});
  check_points(folder.file("both.xyz", rows(" ", " 255 0 17 0 0 1")), {"colours and normals"});
  check_points(folder.file("intensity.xyz", rows(" ", " -1204")), {"look like intensities"});
  check_points(folder.file("many.xyz", rows(" ", " -1204 3e7 -2 5")), {"intensities and other values"});
  check_points(folder.file("scan.pts", "5\n" + rows(" ", " 12 255 0 17")), {"intensities and colours"});
  check_points(folder.file("title.txt", "Scan of a house, 3 stations\n" + rows(" ")));
  check_points(folder.file("named.txt", "//X Y Z R G B\n" + rows(" ", " 1 2 3")), {"named x, y and z"});
  check_points(folder.file("order.csv", "\"id\",\"z\",\"x\",\"y\"\n0,0,0,0\n1,0,1,0\n2,0,0,1.5\n3,-2,0,0\n"
                                        "4,1,0.25,0.5\n"),
               {"named x, y and z"});
  check_points(folder.file("other.txt", "x y z of a house\n" + rows(" ")));
  check_points(folder.file("two.pts", "2\n0 0 0\n1 0 0\n3\n0 1.5 0\n0 0 -2\n.25 .5 1\n"));
  check_points(folder.file("short.pts", "7\n" + rows(" ")), {"announces 7 points and holds 5"});
}

TEST_CASE("rows that are no points are left out with a word, bad ones named with their line") {
  const TemporaryFolder folder;
  check_points(folder.file("nan.xyz", "nan nan nan\n" + rows(" ") + "1 2 -1.#IND\n3 inf 4\n"),
               {"3 points have coordinates that are no number, the first on line 1: left out"});
  check_points(folder.file("ragged.xyz", rows(" ", " 7").insert(57, " 9")),
               {"look like intensities", "1 row has other than 4 columns, the first on line 2"});
  check_bad(folder.file("short.xyz", rows(" ") + "1 2\n"), "line 6: a point has fewer than three");
  check_bad(folder.file("word.xyz", "1 2 3\n1 2 b\n" + rows(" ")), "line 2: \"b\" is no coordinate");
  check_bad(folder.file("first.xyz", "1 2 b\n" + rows(" ")), "line 1: \"b\" is no coordinate");
  check_bad(folder.file("gap.csv", "1,2,3\n1,,3\n"), "line 2: \"\" is no coordinate");
  check_bad(folder.file("words.txt", "once upon a time\nthere was a king\n"), "no row of three numbers");
  check_bad(folder.file("three.xyz", "0 0 0\n1 0 0\n0 1 0\n"), "holds 3 points and no faces");
  check_bad(folder.file("one.xyz", "1 2 3\n1 2 3\n1 2 3\n1 2 3\n"), "all its points at one point");
  check_bad(folder.file("far.xyz", "0 0 0\n1e200 0 0\n0 1 0\n0 0 1\n"), "too large or too small");
  check_bad(folder.file("long.xyz", "0 0 0 " + std::string(20000, '1') + "\n"),
            "line 1: a line of more than");
}

TEST_CASE("mesh files without faces are points") {
  const TemporaryFolder folder;
  const std::string nan = "nan 0 0\n";
  check_points(folder.file("a.off", "OFF\n5 0 0\n" + rows(" ")));
  check_points(folder.file("b.off", "OFF\n6 0 0\n" + nan + rows(" ")), {"1 point has a coordinate"});
  std::string vertices = rows(" ");
  for (std::size_t at = 0; at < vertices.size(); at = vertices.find('\n', at) + 1) vertices.insert(at, "v ");
  check_points(folder.file("a.obj", vertices));
  check_points(folder.file("b.obj", "v " + nan + vertices), {"the first on line 1"});
  check_bad(folder.file("c.obj", "v " + nan + vertices + "f 1 2 3\n"), "line 1: a coordinate is not finite");
  const auto ply = [](std::size_t n) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n) +
           "\nproperty float x\nproperty float y\nproperty double z\nelement face 0\nproperty list uchar int "
           "vertex_indices\nend_header\n";
  };
  check_points(folder.file("a.ply", ply(5) + rows(" ")));
  check_points(folder.file("b.ply", ply(6) + nan + rows(" ")), {"the first on line 10"});
}

TEST_CASE("files of points alone are told before they are read") {
  const TemporaryFolder folder;
  const auto holds = [&](const char* name, const std::string& bytes) {
    CAPTURE(name);
    CAPTURE(bytes);
    return holds_points_alone(folder.file(name, bytes));
  };
  const std::string ply = "ply\r\nformat ascii 1.0\r\ncomment element face 2\r\nelement vertex 2\r\n";
  CHECK(holds("a.xyz", ""));
  CHECK(holds("a.ply", ply + "property float x\r\nend_header\r\n"));
  CHECK(holds("b.ply", ply + "element face 0\r\nend_header\r\n"));
  CHECK_FALSE(holds("c.ply", ply + "element face 2\r\nend_header\r\n"));
  CHECK_FALSE(holds("d.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"));
  CHECK_FALSE(holds("e.ply", ply));
  CHECK(holds("a.off", "# points\nOFF\n\n3 0 0\n0 0 0\n"));
  CHECK(holds("b.OFF", "COFF 3 0 0\n"));
  CHECK_FALSE(holds("c.off", "OFF\n4 4 0\n0 0 0\n"));
  CHECK_FALSE(holds("d.off", "OFF\n0 0 0\n"));
  CHECK(holds("a.obj", "# f 1 2 3\rv 0 0 0\rvn 0 0 1\r"));
  CHECK_FALSE(holds("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n  f 1 2 3\n"));
  CHECK_FALSE(holds("c.obj", "vn 0 0 1\n"));
  CHECK_FALSE(holds("a.stl", "solid\nendsolid\n"));
  CHECK_FALSE(holds("d.obj", std::string(100000, 'v')));
  CHECK_FALSE(holds_points_alone(folder / "missing.ply"));
  CHECK_FALSE(holds_points_alone(folder.path()));
}
