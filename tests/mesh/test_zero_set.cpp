// Zero polygons of every sign pattern; Z of spheres and tori is closed, oriented and has the right topology.
#include "mesh/support.h"
#include "mesh/validity.h"
#include "mesh/zero_set.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace isoscope;
using namespace isoscope::test;

namespace {

double sign(double d) {
  return d < 0 ? -1.0 : 1.0;
}

/// Random points of a box except within `gap` of the surface, labelled by the side of the distance-like
/// function.
Grown label_field(const Box3& box, std::size_t n, double gap, const std::function<double(Vec3)>& d) {
  std::vector<Vec3> points = random_points(n, box.grown(-0.02), 7);
  std::erase_if(points, [&](Vec3 p) { return std::abs(d(p)) < gap; });
  return grow(box, points, [&](Vec3 p) { return sign(d(p)); });
}

double ball(Vec3 p, Vec3 center, double radius) {
  return distance(p, center) - radius;
}

double ring_torus(Vec3 p) {
  const double around = std::hypot(p.x, p.y) - 0.7;
  return std::hypot(around, p.z) - 0.3;
}

const Box3 box{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};

void check_closed_and_oriented(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> halfedges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++halfedges[{t[k], t[(k + 1) % 3]}];
  }
  bool good = true;
  for (const auto& [edge, count] : halfedges) {
    good = good && count == 1 && halfedges.count({edge.second, edge.first}) == 1;
  }
  CHECK(good);
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += dot(cross(mesh.points[t[0]], mesh.points[t[1]]), mesh.points[t[2]]) / 6;
  }
  return sum;
}

} // namespace

TEST_CASE(
    "the zero polygon of each of the 14 sign patterns separates the signs and faces the positive side") {
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0.2, 1, 0}, Vec3{0.1, 0.3, 1}};
  for (unsigned negative = 0; negative < 16; ++negative) {
    std::array<double, 4> f{};
    int count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const bool minus = (negative >> i & 1) != 0;
      f[i] = minus ? -1.0 - i : 1.5 + i;
      count += minus;
    }
    const ZeroPolygon polygon = zero_polygon(p, f);
    INFO(negative);
    CHECK(polygon.count == (count == 0 || count == 4 ? 0 : (count == 2 ? 4 : 3)));
    const AffineFunction g = interpolate(p, f);
    for (std::size_t k = 0; k < static_cast<std::size_t>(polygon.count); ++k) {
      CHECK(f[polygon.edge[k][0]] < 0);
      CHECK(f[polygon.edge[k][1]] > 0);
      CHECK(std::abs(g(polygon.corner[k])) < 1e-12);
      const std::size_t n = static_cast<std::size_t>(polygon.count);
      const auto &a = polygon.corner[k], &b = polygon.corner[(k + 1) % n], &c = polygon.corner[(k + 2) % n];
      CHECK(dot(cross(b - a, c - b), g.gradient) > 0);
      const auto &e0 = polygon.edge[k], &e1 = polygon.edge[(k + 1) % n];
      CHECK((e0[0] == e1[0]) != (e0[1] == e1[1]));
    }
  }
}

TEST_CASE("zeros are midpoints and dyadic fractions to the last bit, and F = 0 leaves no polygon") {
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{8, 0, 0}, Vec3{0, 8, 0}, Vec3{0, 0, 8}};
  const ZeroPolygon half = zero_polygon(p, {-1, 1, 1, 1});
  CHECK(half.corner[0] == Vec3{4, 0, 0});
  const ZeroPolygon eighth = zero_polygon(p, {7, -1, -1, -1});
  CHECK(eighth.count == 3);
  for (int k = 0; k < 3; ++k) {
    const Vec3 c = eighth.corner[static_cast<std::size_t>(k)];
    CHECK(c.x + c.y + c.z == 7);
  }
  for (const std::array<double, 4>& f :
       {std::array<double, 4>{0, 0, 0, 0}, {0, -1, 1, 1}, {0, 0, -1, 1}, {0, 1, 1, 1}}) {
    CHECK(zero_polygon(p, f).count == 0);
  }
}

TEST_CASE("Z of a ball is one closed sphere that faces outward") {
  const Grown g = label_field(box, 6000, 0.05, [](Vec3 p) { return ball(p, {}, 0.9); });
  const ZeroSet z = extract_zero_set(g.complex);
  CHECK(z.components.size() == 1);
  CHECK(z.euler_characteristic() == 2);
  CHECK(z.components[0].genus() == 0);
  CHECK(z.components[0].polygons == z.polygons.size());
  CHECK(z.components[0].vertices == z.vertices.size());
  for (const auto& v : z.vertices) {
    CHECK(g.complex.value(v.negative) < 0);
    CHECK(g.complex.value(v.positive) > 0);
  }
  CHECK(std::is_sorted(z.polygons.begin(), z.polygons.end(), [](auto& a, auto& b) { return a.tet < b.tet; }));
  const TriangleMesh mesh = triangulate(z);
  check_closed_and_oriented(mesh);
  CHECK(volume(mesh) == doctest::Approx(4.0 / 3.0 * 3.14159265 * 0.729).epsilon(0.05));
}

TEST_CASE("Z of a torus has Euler characteristic 0 and genus 1") {
  const Grown g = label_field(box, 12000, 0.02, ring_torus);
  const ZeroSet z = extract_zero_set(g.complex);
  REQUIRE(z.components.size() == 1);
  CHECK(z.euler_characteristic() == 0);
  CHECK(z.components[0].genus() == 1);
  const TriangleMesh mesh = triangulate(z);
  check_closed_and_oriented(mesh);
  CHECK(volume(mesh) > 0);
}

TEST_CASE("two balls give two components, each with its own counts") {
  const Grown g = label_field(box, 12000, 0.02, [](Vec3 p) {
    return std::min(ball(p, {-0.55, 0, 0}, 0.4), ball(p, {0.5, 0.1, 0}, 0.5));
  });
  const ZeroSet z = extract_zero_set(g.complex);
  REQUIRE(z.components.size() == 2);
  CHECK(z.euler_characteristic() == 4);
  for (const auto& c : z.components) CHECK(c.euler_characteristic() == 2);
  CHECK(z.components[0].vertices + z.components[1].vertices == z.vertices.size());
  CHECK(z.polygons.front().component == 0);
  check_closed_and_oriented(triangulate(z));
}

TEST_CASE("the polygons of Z are those of its tetrahedra, bit by bit") {
  const Grown g = label_field(box, 2000, 0.05, ring_torus);
  const ZeroSet z = extract_zero_set(g.complex);
  std::size_t carrying = 0;
  for (std::size_t i = 0; i < g.complex.tets.size(); ++i) {
    carrying += g.complex.tets[i].alive() && g.complex.heterogeneous(TetId(i));
  }
  CHECK(z.polygons.size() == carrying);
  bool same = true;
  for (const auto& p : z.polygons) {
    const ZeroPolygon own = zero_polygon(g.complex.positions(p.tet), g.complex.values(p.tet));
    same = same && own.count == p.count;
    for (std::size_t k = 0; k < p.count; ++k) same = same && own.corner[k] == z.vertices[p.v[k]].position;
  }
  CHECK(same);
}

TEST_CASE("the boundary of Gamma has all facets between carrying and other tetrahedra, facing outward, and "
          "is closed") {
  const Grown g = label_field(box, 3000, 0.05, [](Vec3 p) { return ball(p, {}, 0.8); });
  const Complex& c = g.complex;
  std::size_t expected = 0;
  for (std::size_t i = 0; i < c.tets.size(); ++i) {
    if (!c.tets[i].alive() || !c.heterogeneous(TetId(i))) continue;
    for (const TetId n : c.tets[i].neighbor) expected += !n.valid() || !c.heterogeneous(n);
  }
  const auto facets = gamma_boundary(c);
  CHECK(facets.size() == expected);
  std::map<std::pair<VertexId, VertexId>, int> balance;
  for (const GammaFacet& f : facets) {
    const double first = c.value(f.v[0]);
    CHECK((c.value(f.v[1]) > 0) == (first > 0));
    CHECK((c.value(f.v[2]) > 0) == (first > 0));
    const auto p = c.positions(f.tet);
    const Vec3 middle = 0.25 * (p[0] + p[1] + p[2] + p[3]), a = c.position(f.v[0]);
    CHECK(dot(cross(c.position(f.v[1]) - a, c.position(f.v[2]) - a), middle - a) < 0);
    for (std::size_t k = 0; k < 3; ++k) {
      ++balance[{f.v[k], f.v[(k + 1) % 3]}];
      --balance[{f.v[(k + 1) % 3], f.v[k]}];
    }
  }
  CHECK(std::all_of(balance.begin(), balance.end(), [](const auto& b) { return b.second == 0; }));
}

TEST_CASE("an empty complex has an empty Z") {
  const ZeroSet z = extract_zero_set(Complex{});
  CHECK(z.vertices.empty());
  CHECK(z.components.empty());
  CHECK(z.euler_characteristic() == 0);
  CHECK(triangulate(z).triangles.empty());
}
