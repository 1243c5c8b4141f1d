// Damaged files of every format either read soundly or are refused by name; nothing else happens.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/mutations.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

using namespace isoscope;

namespace {

std::string utf16(const std::string& text) {
  std::string bytes = "\xff\xfe";
  for (const char c : text) (bytes += c) += '\0';
  return bytes;
}

/// An OFF file of one face of 200 corners, zigzag around a square.
std::string large_polygon() {
  std::string points, face = "200";
  for (int i = 0; i < 200; ++i) {
    const int k = i % 50, side = i / 50;
    const std::string along = std::to_string(side < 2 ? k : 50 - k), across = std::to_string(i % 2);
    const std::string far = std::to_string(50 - i % 2);
    points += side == 0   ? along + " " + across
              : side == 1 ? far + " " + along
              : side == 2 ? along + " " + far
                          : across + " " + along;
    points += " 0\n";
    face += " " + std::to_string(i);
  }
  return "OFF\n200 1 0\n" + points + face + "\n";
}

TriangleMesh small_mesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 1.5, -3}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}}};
}

} // namespace

TEST_CASE("thousands of damaged files") {
  const TemporaryFolder folder;
  std::vector<std::string> seeds{
      "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty "
      "list uchar int extra\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 "
      "5\n1 0 0 0\n1 1 0 "
      "0\n0 1 0 2 1 1\n4 0 1 2 3\n3 0 1 2\n",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid a\n",
      "COFF\n5 2 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n1 1 0 1 1 1\n0.5 0.2 0 1 1 1\n0 1 0 1 1 1\n5 0 1 2 3 4 9 9 "
      "9\n3 0 1 2\n",
      "v 0 0 0\nv 1 0 0\nv 1 1 0 0.5\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\nf -1 -2 \\\n -3\n"};
  seeds.push_back("off 4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3 3 0 1 2\n");
  seeds.push_back("v 0 0 0\rv 1 0 0\rv 1 1 0 nan nan nan\rv 0 1 0\rf 1 2\\\r3 4\r");
  seeds.push_back(utf16("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"));
  seeds.push_back(large_polygon());
  for (const char* extension : {".off", ".obj", ".ply", ".stl"}) {
    const auto file = folder / ("seed" + std::string(extension));
    REQUIRE(write_mesh(file, small_mesh()).ok());
    seeds.push_back(bytes_of(file));
  }
  constexpr std::array<std::string_view, 11> words{"-", "9999999999", "nan", " ",  "\n",  "1e400",
                                                   "/", "#",          "\\",  "\r", "end "};
  test::Draws draws(42);
  int read = 0, refused = 0;
  for (const std::string& seed : seeds) {
    for (int i = 0; i < 700; ++i) {
      const std::string bytes = test::edited(seed, draws, words);
      const auto file = folder.file(
          std::vector<std::string>{"m", "m.off", "m.obj", "m.ply", "m.stl"}[draws.below(5)], bytes);
      const auto mesh = read_mesh(file);
      if (!mesh) {
        ++refused;
        REQUIRE(mesh.error().message.find(file.string()) != std::string::npos);
        REQUIRE(mesh.error().line().find('\n') == std::string::npos);
        continue;
      }
      ++read;
      REQUIRE((!mesh->triangles.empty() || mesh->points.size() >= 4));
      for (const Vec3 p : mesh->points) REQUIRE(is_finite(p));
      for (const auto& t : mesh->triangles)
        for (const auto v : t) REQUIRE(v < mesh->points.size());
    }
  }
  CHECK(read > 500);
  CHECK(refused > 500);
}
