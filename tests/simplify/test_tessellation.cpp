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
