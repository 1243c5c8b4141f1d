// The bundled models are what their cards say.
#include "input/gallery.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

using namespace isoscope;

namespace {

TriangleSoup make(std::string_view name) {
  auto model = make_gallery_model(name);
  REQUIRE(model.ok());
  return *model;
}

double volume(const TriangleSoup& model) {
  double sum = 0;
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    const Triangle3 t = model.triangle(i);
    sum += dot(t[0], cross(t[1], t[2])) / 6;
  }
  return sum;
}

using HalfEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

HalfEdges half_edges(const TriangleSoup& model) {
  HalfEdges edges;
  for (const auto& t : model.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  return edges;
}

} // namespace

TEST_CASE("clean models are closed oriented manifolds of the stated Euler characteristic that do not cross "
          "themselves") {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  for (const GalleryEntry& entry : gallery()) {
    if (entry.name == "soup" || entry.name == "two-rooms" || entry.name == "bubbles") continue;
    if (entry.boundary_loops > 0 || entry.gives_volume() || make(entry.name).is_point_set()) continue;
    CAPTURE(entry.name);
    const TriangleSoup model = make(entry.name);
    CHECK(model.triangles.size() >= 500);
    CHECK(model.triangles.size() <= 20000);
    const HalfEdges edges = half_edges(model);
    for (const auto& [edge, count] : edges) {
      REQUIRE(count == 1);
      REQUIRE(edges.contains({edge.second, edge.first}));
    }
    const auto chi = static_cast<long>(model.points.size()) - static_cast<long>(edges.size() / 2) +
                     static_cast<long>(model.triangles.size());
    CHECK(chi == entry.euler_characteristic);
    CHECK(volume(model) > 0);

    Mesh mesh;
    std::vector<Mesh::Vertex_index> ids;
    for (const Vec3 p : model.points) ids.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    // A face is refused where a vertex would be pinched.
    for (const auto& t : model.triangles)
      REQUIRE(mesh.add_face(ids[t[0]], ids[t[1]], ids[t[2]]) != Mesh::null_face());
    CHECK_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh));
  }
}

TEST_CASE("the bracket is the solid that its drawing shows") {
  // Foot and lug with their areas of 48-gons: n/2 sin(2π/n) r² instead of π r².
  const double disc = 24 * 0.13052619222005157;
  const double foot = 4 * 6 - (2 - disc / 2) - 2 * disc * 0.55 * 0.55;
  const double lug = 4 * 2 + disc * 4 / 2 - disc;
  CHECK(volume(make("bracket")) == doctest::Approx(foot + lug).epsilon(1e-12));
}

TEST_CASE("two calls give the same bits") {
  for (const GalleryEntry& entry : gallery()) {
    const TriangleSoup a = make(entry.name), b = make(entry.name);
    CHECK(a.name == entry.name);
    CHECK(a.triangles == b.triangles);
    REQUIRE(a.points.size() == b.points.size());
    CHECK(std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Vec3)) == 0);
  }
}

TEST_CASE("the soup has gaps, overlaps, flipped and double triangles") {
  const TriangleSoup soup = make("soup"), torus = make("torus");
  std::set<std::array<std::uint32_t, 3>> distinct;
  std::size_t doubles = 0, flipped = 0, enlarged = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    auto key = soup.triangles[i];
    std::sort(key.begin(), key.end());
    if (!distinct.insert(key).second) ++doubles;
    const Triangle3 t = soup.triangle(i);
    const Vec3 center = (t[0] + t[1] + t[2]) / 3.0, ring = normalized(Vec3{center.x, center.y, 0});
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    if (dot(normal, center - ring) < 0) ++flipped;
    if (length(normal) > 0.023) ++enlarged;
  }
  CHECK(doubles > 200);
  CHECK(flipped > 500);
  CHECK(flipped < soup.triangles.size() / 2);
  CHECK(enlarged > 50);
  CHECK(distinct.size() < torus.triangles.size() - 200); // gaps
}

TEST_CASE("every gap of the soup is far smaller than its tolerance") {
  const TriangleSoup soup = make("soup"), torus = make("torus");
  const auto entry =
      *std::find_if(gallery().begin(), gallery().end(), [](const auto& e) { return e.name == "soup"; });
  const double delta = entry.tolerance_percent / 100 * soup.bounds().longest_edge();
  for (const Vec3 p : torus.points) {
    double nearest = Box3::inf;
    for (const Vec3 q : soup.points) nearest = std::min(nearest, distance(p, q));
    REQUIRE(nearest < 0.25 * delta);
  }
}

TEST_CASE("every entry has its card, and unknown names are answered with the list") {
  std::set<std::string_view> names;
  for (const GalleryEntry& entry : gallery()) {
    CHECK(names.insert(entry.name).second);
    CHECK_FALSE(entry.title.empty());
    CHECK(entry.lesson.ends_with('.'));
    CHECK(entry.tolerance_percent >= 0);
    CHECK(entry.tolerance_percent < 10);
  }
  const auto unknown = make_gallery_model("teapot");
  REQUIRE_FALSE(unknown.ok());
  CHECK(unknown.error().code == ErrorCode::bad_input);
  CHECK(unknown.error().line().find("double-torus") != std::string::npos);
}
