// The mutual tessellation keeps Z where it is and makes it facets of T; the departure keeps those facets.
#include "simplify/simplified.h"

#include "mesh/validity.h"
#include "mesh/zero_set.h"
#include "simplify/tessellation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace isoscope;
using namespace isoscope::testing;

namespace {

std::vector<std::array<double, 3>> sorted_points(const ZeroSet& z) {
  std::vector<std::array<double, 3>> points;
  for (const auto& v : z.vertices) points.push_back({v.position.x, v.position.y, v.position.z});
  std::sort(points.begin(), points.end());
  return points;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += 0.5 * length(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
  }
  return sum;
}

} // namespace

TEST_CASE("a single tetrahedron cut 2-2 becomes six, three on each side") {
  Complex c;
  const std::array<Vec3, 4> p{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 4}};
  for (std::size_t i = 0; i < 4; ++i) {
    Vertex v;
    v.position = p[i];
    v.value = i < 2 ? -1 : 1;
    c.vertices.push_back(v);
  }
  Tet t;
  t.v = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  c.tets.push_back(t);
  auto delta = mutual_tessellation(c);
  REQUIRE(delta.ok());
  CHECK(delta->added_vertices.size() == 4);
  CHECK(delta->added.size() == 6);
  CHECK(std::count_if(delta->added.begin(), delta->added.end(), [](const auto& r) { return r.side > 0; }) ==
        3);
  const Complex before = c;
  c.apply(*delta);
  CHECK(check_complex(c).empty());
  CHECK(extract_zero_set(c).polygons.size() == 2);
  c.undo(*delta);
  CHECK(c == before);
}

namespace {

/// A tetrahedron around the middle of an edge from `a` to `b`, the edge in it, split into four.
Complex around_edge(Vec3 a, Vec3 b, const std::array<Vec3, 3>& ring) {
  Complex c;
  const auto add = [&](Vec3 p, double value) {
    Vertex v;
    v.position = p;
    v.value = value;
    c.vertices.push_back(v);
  };
  add(a, -1);
  add(b, +1);
  for (const Vec3 p : ring) add(p, -1);
  for (std::uint32_t k = 0; k < 3; ++k) {
    Tet t;
    t.v = {VertexId(0), VertexId(1), VertexId(2 + k), VertexId(2 + (k + 1) % 3)};
    c.tets.push_back(t);
  }
  return c;
}

} // namespace

TEST_CASE("where a zero is no double the place beside it is taken that turns nothing over") {
  const double far = std::ldexp(1.0, 30), step = std::ldexp(1.0, -22); // the spacing there
  const std::array<Vec3, 3> wide{Vec3{far - 1, 1, 0}, Vec3{far - 1, -1, 1}, Vec3{far - 1, -1, -1}};
  // The zero of the edge lies between two doubles, its rounding at an end of it.
  const Complex tight = around_edge({far, 0, 0}, {far + step, 0, 0}, wide);
  const auto none = mutual_tessellation(tight);
  REQUIRE_FALSE(none.ok());
  CHECK(none.error().code == ErrorCode::unsupported);
  CHECK(none.error().message.find("The digits of the coordinates do not suffice") == 0);
  CHECK(none.error().remedy.find("origin") != std::string::npos);
  // With one double more between them there is a place.
  CHECK(mutual_tessellation(around_edge({far, 0, 0}, {far + 3 * step, 0, 0}, wide)).ok());
}

TEST_CASE("tessellation and departure keep the vertices, the area and the topology of Z") {
  for (const char* model : {"sphere", "torus", "bracket"}) {
    CAPTURE(model);
    Bench bench = Bench::gallery(model, {.percent = 3});
    bench.run();
    Complex c = bench.complex();
    const ZeroSet before = extract_zero_set(c);
    const auto delta = mutual_tessellation(c);
    REQUIRE(delta.ok());
    c.apply(*delta);
    CHECK(c.form == ZeroForm::embedded);
    CHECK(check_complex(c).empty());
    const ZeroSet embedded = extract_zero_set(c);
    CHECK(sorted_points(embedded) == sorted_points(before));
    CHECK(embedded.euler_characteristic() == before.euler_characteristic());
    CHECK(embedded.components.size() == before.components.size());
    CHECK(area(triangulate(embedded)) == doctest::Approx(area(triangulate(before))).epsilon(1e-9));
    for (const Tet& t : c.tets) {
      if (!t.alive()) continue;
      for (const VertexId v : t.v) CHECK(c.value(v) * t.side >= 0);
    }

    const Complex kept = c;
    const Delta left = departure(c);
    c.apply(left);
    CHECK(c.form == ZeroForm::free);
    CHECK(c.alive_tets() == 0);
    const ZeroSet freed = extract_zero_set(c);
    CHECK(sorted_points(freed) == sorted_points(before));
    CHECK(freed.euler_characteristic() == before.euler_characteristic());
    c.undo(left);
    CHECK(c == kept);
  }
}
