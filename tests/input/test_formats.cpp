// Good files of every format and dialect give the surface they describe.
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/models.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <doctest/doctest.h>

#include <cstring>

using namespace isoscope;

namespace {

constexpr std::string_view tetrahedron_rows =
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

void check_tetrahedron(const Result<TriangleSoup>& mesh) {
  if (!mesh) FAIL(mesh.error().line());
  CHECK(mesh->points.size() == 4);
  REQUIRE(mesh->triangles.size() == 4);
  double volume = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle3 t = mesh->triangle(i);
    volume += dot(t[0], cross(t[1], t[2])) / 6;
  }
  CHECK(volume == doctest::Approx(1.0 / 6));
}

template <class T> std::string raw(std::initializer_list<T> values, bool swapped = false) {
  std::string bytes;
  for (const T v : values) {
    std::string b(sizeof(T), '\0');
    std::memcpy(b.data(), &v, sizeof(T));
    if (swapped) b.assign(b.rbegin(), b.rend());
    bytes += b;
  }
  return bytes;
}

std::string binary_ply(bool big_endian) {
  std::string ply =
      std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
      "_endian 1.0\ncomment made by hand\nelement vertex 4\nproperty uchar red\nproperty float x\n"
      "property float y\nproperty double z\nelement face 4\nproperty list uchar int vertex_indices\n"
      "property short quality\nend_header\n";
  const auto vertex = [&](float x, float y, double z) {
    ply += raw<unsigned char>({200}) + raw({x, y}, big_endian) + raw({z}, big_endian);
  };
  const auto face = [&](int a, int b, int c) {
    ply += raw<unsigned char>({3}) + raw({a, b, c}, big_endian) + raw<short>({-1}, big_endian);
  };
  vertex(0, 0, 0), vertex(1, 0, 0), vertex(0, 1, 0), vertex(0, 0, 1);
  face(0, 2, 1), face(0, 1, 3), face(1, 2, 3), face(2, 0, 3);
  return ply;
}

} // namespace

TEST_CASE("OFF in its dialects") {
  const TemporaryFolder folder;
  const std::string rows(tetrahedron_rows);
  check_tetrahedron(read_mesh(folder.file("a.off", "OFF\n4 4 6\n" + rows)));
  check_tetrahedron(read_mesh(folder.file("b.off", "OFF 4 4 0\n" + rows)));
  check_tetrahedron(read_mesh(folder.file("c.off", "OFF4 4 0\n" + rows)));
  check_tetrahedron(
      read_mesh(folder.file("d.off", "# a comment\n\nOFF # another\n\n4 4 # no edges\n\n" + rows)));
  check_tetrahedron(read_mesh(folder.file("no_extension", "OFF\n4 4 6\n" + rows)));
  check_tetrahedron(read_mesh(folder.file("lies.stl", "\xef\xbb\xbfOFF\n4 4 6\n" + rows)));
  check_tetrahedron(
      read_mesh(folder.file("colour.off", "COFF\n4 4 0\n0 0 0 255 0 0 1\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n0 0 1 "
                                          "9 9 9 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 3")));
  check_tetrahedron(read_mesh(folder.file(
      "w.off", "4OFF\n4 4 0\n0 0 0 1\n2 0 0 2\n0 4 0 4\n0 0 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")));
  std::string windows = "OFF\n4 4 6\n" + rows;
  for (std::size_t i = 0; (i = windows.find('\n', i)) != std::string::npos; i += 2) windows.insert(i, "\r");
  check_tetrahedron(read_mesh(folder.file("windows.off", windows)));
}

TEST_CASE("OBJ with slashes, negative indices, continued lines and other statements") {
  const TemporaryFolder folder;
  check_tetrahedron(read_mesh(folder.file(
      "a.obj", "# comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nv 0 0 1 0.5 0.5 0.5\n"
               "vt 0 0\nvn 0 0 1\nusemtl red\ns off\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\n"
               "f -3 -2 \\\n-1\nf 3/1 1/1 4/1\n")));
}

TEST_CASE("PLY as text and binary in both byte orders, with foreign properties and elements") {
  const TemporaryFolder folder;
  check_tetrahedron(read_mesh(folder.file(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float z\nproperty float y\nproperty float "
      "x\nproperty float "
      "quality\nelement edge 1\nproperty int a\nproperty list uchar float b\nelement face 4\nproperty list "
      "uchar int vertex_index\nend_header\n0 0 0 nan\n0 0 1 1\n0 1 0 1\n1 0 0 1\n7 2 0.5 0.5\n3 0 2 1\n3 0 1 "
      "3\n3 1 2 3\n3 2 0 3\n")));
  check_tetrahedron(read_mesh(folder.file("b.ply", binary_ply(false))));
  check_tetrahedron(read_mesh(folder.file("c.ply", binary_ply(true))));
}

TEST_CASE("STL as text and binary joins equal corners") {
  const TemporaryFolder folder;
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string text = "solid a name of words\n", binary(80, ' ');
  binary.replace(0, 5, "solid"); // some programs begin binary files so
  binary += raw({4});
  for (const auto& f : faces) {
    text += "facet normal 0 0 nan\n outer loop\n";
    binary += raw({0.f, 0.f, 0.f});
    for (const int v : f) {
      text += "vertex " + std::to_string(p[v][0]) + " " + std::to_string(p[v][1]) + " " +
              std::to_string(p[v][2]) + "\n";
      binary += raw({p[v][0], p[v][1], p[v][2]});
    }
    text += "endloop\nendfacet\n";
    binary += raw<short>({0});
  }
  check_tetrahedron(read_mesh(folder.file("a.stl", text + "endsolid a name\n")));
  check_tetrahedron(read_mesh(folder.file("b.stl", binary)));
  check_tetrahedron(read_mesh(folder.file("b", binary)));
}

TEST_CASE("polygons are triangulated, faces that name a vertex twice are dropped, slivers kept") {
  const TemporaryFolder folder;
  const auto cube = read_mesh(folder.file("cube.off", "OFF\n9 7 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 "
                                                      "1\n1 1 1\n0 1 1\n9 9 9\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 "
                                                      "4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n3 0 0 1\n"));
  REQUIRE(cube.ok());
  CHECK(cube->triangles.size() == 12);
  CHECK(cube->bounds().longest_edge() == 1); // the unused vertex is no part of it
  const auto sliver =
      read_mesh(folder.file("sliver.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n"));
  REQUIRE(sliver.ok());
  CHECK(sliver->triangles.size() == 2);
}

TEST_CASE("what is written is read back: every bit in OFF, OBJ and PLY, floats in STL") {
  const TemporaryFolder folder;
  for (const std::string_view name : {"bracket", "soup"}) {
    const auto model = make_gallery_model(name);
    REQUIRE(model.ok());
    TriangleMesh mesh{model->points, model->triangles};
    mesh.points[0] = mesh.points[0] + Vec3{1e-17, 0.1, 1.0 / 3};
    for (const std::string_view extension : {".off", ".obj", ".ply", ".OFF"}) {
      const auto file = folder / ("m" + std::string(extension));
      REQUIRE(write_mesh(file, mesh).ok());
      const auto back = read_mesh(file);
      REQUIRE(back.ok());
      CHECK(back->triangles == mesh.triangles);
      REQUIRE(back->points.size() == mesh.points.size());
      CHECK(std::memcmp(back->points.data(), mesh.points.data(), mesh.points.size() * sizeof(Vec3)) == 0);
    }
    REQUIRE(write_mesh(folder / "m.stl", mesh).ok());
    const auto back = read_mesh(folder / "m.stl");
    REQUIRE(back.ok());
    REQUIRE(back->triangles.size() == mesh.triangles.size());
    double worst = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        worst = std::max(worst, distance(back->triangle(i)[k], mesh.points[mesh.triangles[i][k]]));
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("real models read as CGAL reads them") {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  for (const char* name : {"elephant.off", "pig.stl", "sphere.ply", "colored_tetra.ply", "cheese.off"}) {
    const auto file = demo_model(name);
    if (!file) continue;
    CAPTURE(name);
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    REQUIRE(CGAL::IO::read_polygon_soup(file->string(), points, faces));
    const auto mesh = read_mesh(*file);
    REQUIRE(mesh.ok());
    REQUIRE(mesh->points.size() == points.size());
    REQUIRE(mesh->triangles.size() == faces.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      REQUIRE(mesh->points[i] == Vec3{points[i].x(), points[i].y(), points[i].z()});
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) REQUIRE(mesh->triangles[i][k] == faces[i][k]);
  }
}
