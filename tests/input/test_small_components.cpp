// Crumbs are found by their boxes and go as wholes.
#include "input/small_components.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

/// A tetrahedron of that size at `at`; with `own_points` each triangle has points of its own.
void add_tetrahedron(TriangleSoup& soup, Vec3 at, double size, bool own_points = false) {
  const Vec3 p[4] = {at, at + Vec3{size, 0, 0}, at + Vec3{0, size, 0}, at + Vec3{0, 0, size}};
  const std::uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  if (!own_points) soup.points.insert(soup.points.end(), p, p + 4);
  for (const auto& f : faces) {
    std::array<std::uint32_t, 3> t{first + f[0], first + f[1], first + f[2]};
    for (std::size_t k = 0; own_points && k < 3; ++k) {
      t[k] = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(p[f[k]]);
    }
    soup.triangles.push_back(t);
  }
}

} // namespace

TEST_CASE("components smaller than the size are left out, and their points with them") {
  TriangleSoup soup;
  soup.name = "crumbs";
  add_tetrahedron(soup, {5, 0, 0}, 0.1);
  add_tetrahedron(soup, {0, 0, 0}, 2);
  add_tetrahedron(soup, {0, 5, 0}, 0.5, true);
  soup.points.push_back({9, 9, 9}); // of no triangle
  const auto rest = drop_small_components(soup, 0.3, RunControl{});
  CHECK(rest.components == 3);
  CHECK(rest.dropped_components == 1);
  CHECK(rest.dropped_triangles == 4);
  CHECK(rest.soup.points.size() == 4 + 12);
  CHECK(rest.soup.name == soup.name);
  REQUIRE(rest.soup.triangles.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) CHECK(rest.soup.triangle(i) == soup.triangle(i + 4));

  const auto large = drop_small_components(soup, 0.6, RunControl{});
  CHECK(large.dropped_components == 2); // one of them hangs together by its coordinates alone
  CHECK(large.soup.triangles.size() == 4);
  CHECK(drop_small_components(soup, 0.1, RunControl{}).dropped_components == 0); // not smaller than that
  CHECK(drop_small_components(soup, 3, RunControl{}).soup.triangles.empty());
}

TEST_CASE("vertices of small parts of a mesh are counted") {
  TriangleSoup soup;
  add_tetrahedron(soup, {0, 0, 0}, 2);
  add_tetrahedron(soup, {5, 0, 0}, 0.1);
  add_tetrahedron(soup, {0, 5, 0}, 0.5);
  const TriangleMesh mesh{soup.points, soup.triangles};
  CHECK(count_small_parts(mesh, 0.6).components == 2);
  CHECK(count_small_parts(mesh, 0.6).vertices == 8);
  CHECK(count_small_parts(mesh, 0.1).vertices == 0);
}
